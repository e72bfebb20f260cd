#pragma once
// Short ways to write the shapes of fast's tests.

#include <memory>
#include <utility>
#include <vector>

#include <groundtruth/problem/scene.hpp>

namespace groundtruth {

inline Shape half_space(Vector normal, double offset) { return {HalfSpace{normal, offset}}; }
inline Shape unite(std::vector<Shape> operands) { return {Union{std::move(operands)}}; }
inline Shape intersect(std::vector<Shape> operands) { return {Intersection{std::move(operands)}}; }
inline Shape cover(MaterialIndex material, Shape over) {
  return {Covered{material, std::make_shared<Shape>(std::move(over))}};
}
inline Shape paint(MaterialIndex material, Shape where, Shape over) {
  return {
      Painted{material, std::make_shared<Shape>(std::move(where)), std::make_shared<Shape>(std::move(over))}};
}

// Leaves in the order -x, +x, -y, +y, -z, +z.
inline Shape box(Vector low, Vector high) {
  std::vector<Shape> faces;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Vector normal{};
    normal[axis] = -1;
    faces.push_back(half_space(normal, -low[axis]));
    normal[axis] = 1;
    faces.push_back(half_space(normal, high[axis]));
  }
  return intersect(std::move(faces));
}

}  // namespace groundtruth
