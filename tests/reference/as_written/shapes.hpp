#pragma once
// Short ways to write shapes down.

#include <memory>
#include <utility>
#include <vector>

#include <groundtruth/problem/scene.hpp>

namespace groundtruth::as_written {

inline Shape half_space(const Vector& normal, double offset) { return {HalfSpace{normal, offset}}; }
inline Shape union_of(std::vector<Shape> operands) { return {Union{std::move(operands)}}; }
inline Shape intersection_of(std::vector<Shape> operands) { return {Intersection{std::move(operands)}}; }

inline Shape covered(MaterialIndex material, Shape over) {
  return {Covered{material, std::make_shared<const Shape>(std::move(over))}};
}

inline Shape painted(MaterialIndex material, Shape where, Shape over) {
  return {Painted{material, std::make_shared<const Shape>(std::move(where)),
                  std::make_shared<const Shape>(std::move(over))}};
}

// Leaves in the order -x, +x, -y, +y, -z, +z.
inline Shape box(const Vector& low, const Vector& high) {
  return intersection_of({half_space({-1, 0, 0}, -low[0]), half_space({1, 0, 0}, high[0]),
                          half_space({0, -1, 0}, -low[1]), half_space({0, 1, 0}, high[1]),
                          half_space({0, 0, -1}, -low[2]), half_space({0, 0, 1}, high[2])});
}

inline groundtruth::Scene bare(Shape shape) { return {{}, std::move(shape)}; }

}  // namespace groundtruth::as_written
