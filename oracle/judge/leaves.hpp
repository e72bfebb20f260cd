#pragma once
// What the judge reads from a shape: its leaves, the materials they may have at a point, and the same shape
// in another order. Private to this folder.

#include <optional>
#include <set>
#include <vector>

#include <groundtruth/problem/scene.hpp>

#include "number.hpp"

namespace groundtruth::judge {

std::size_t leaf_count(const Shape& shape);

// By leaf number.
std::vector<HalfSpace> leaves_of(const Shape& shape);

using MaterialOrNone = std::optional<MaterialIndex>;

// A ball; of radius 0 a point.
struct Around {
  RationalVector point_in_world;
  double radius = 0;
};

// The materials that the leaf has at the points of the ball: those of SPEC section 2, where a region of paint
// counts both ways if its half-spaces, moved by at most the radius, may or may not contain the point. Exactly
// one if the radius is 0.
std::set<MaterialOrNone> materials_of(const Shape& shape, Leaf leaf, const Around& around);

// The same solid with this leaf numbered 0: at each union and intersection on the way to it, its operand
// comes first. Numbering is all that changes (proofs-notes/tolerance.md, 4). Requires leaf < number of
// leaves.
Shape with_leaf_first(const Shape& shape, Leaf leaf);

}  // namespace groundtruth::judge
