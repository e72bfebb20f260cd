#pragma once
// Which leaves are faces of a solid at a point (SPEC section 3), found by membership of sample points so near
// that no plane through none of the points they were reached from lies between.

#include <vector>

#include <groundtruth/definition/first_member.hpp>

namespace groundtruth::definition {

struct Faces {
  bool interior = false;         // of the solid; then there is no face
  std::vector<Leaf> admissible;  // ascending
};

// At the moment at which `segment` first meets the solid (as `first_member` says).
Faces faces_at(const Expression& expression, const Segment& segment, const Moment& moment);

// What the face `leaf` is made of at a point on it; absent: no material.
std::optional<MaterialIndex> material_at(const Expression& expression, Leaf leaf, const Point& point);

}  // namespace groundtruth::definition
