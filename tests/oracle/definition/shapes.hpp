#pragma once
// Shapes for tests, in few words.

#include <initializer_list>
#include <memory>

#include <groundtruth/problem/scene.hpp>
#include <groundtruth/problem/shape.hpp>

namespace groundtruth::definition::test {

inline Shape half_space(double x, double y, double z, double offset) {
  return {HalfSpace{{x, y, z}, offset}};
}
inline Shape any_of(std::vector<Shape> operands) { return {Union{std::move(operands)}}; }
inline Shape all_of(std::vector<Shape> operands) { return {Intersection{std::move(operands)}}; }

// Its leaves in the order -x, +x, -y, +y, -z, +z.
inline Shape box(const Vector& low, const Vector& high) {
  return all_of({half_space(-1, 0, 0, -low[0]), half_space(1, 0, 0, high[0]), half_space(0, -1, 0, -low[1]),
                 half_space(0, 1, 0, high[1]), half_space(0, 0, -1, -low[2]), half_space(0, 0, 1, high[2])});
}

inline Shape made_of(MaterialIndex material, Shape over) {
  return {Covered{material, std::make_shared<const Shape>(std::move(over))}};
}

inline Shape painted(MaterialIndex material, Shape where, Shape over) {
  return {Painted{material, std::make_shared<const Shape>(std::move(where)),
                  std::make_shared<const Shape>(std::move(over))}};
}

inline groundtruth::Scene scene_of(Shape shape) { return {{}, std::move(shape)}; }

}  // namespace groundtruth::definition::test
