#pragma once
// Short ways to write shapes, and to walk them.

#include <memory>
#include <utility>
#include <vector>

#include <groundtruth/problem/scene.hpp>

namespace groundtruth::properties {

inline Shape half_space(double x, double y, double z, double offset) {
  return {HalfSpace{{x, y, z}, offset}};
}
inline Shape any_of(std::vector<Shape> operands) { return {Union{std::move(operands)}}; }
inline Shape all_of(std::vector<Shape> operands) { return {Intersection{std::move(operands)}}; }
inline Shape box(const Vector& low, const Vector& high) {
  return all_of({half_space(-1, 0, 0, -low[0]), half_space(1, 0, 0, high[0]), half_space(0, -1, 0, -low[1]),
                 half_space(0, 1, 0, high[1]), half_space(0, 0, -1, -low[2]), half_space(0, 0, 1, high[2])});
}
inline Shape covered(MaterialIndex material, Shape over) {
  return {Covered{material, std::make_shared<const Shape>(std::move(over))}};
}
inline Shape painted(MaterialIndex material, Shape where, Shape over) {
  return {Painted{material, std::make_shared<const Shape>(std::move(where)),
                  std::make_shared<const Shape>(std::move(over))}};
}

// The operands of a union or an intersection; none of anything else.
std::vector<Shape> operands_of(const Shape& shape);
// The same operation on other operands. Requires a union or an intersection.
Shape with_operands(const Shape& shape, std::vector<Shape> operands);

std::vector<HalfSpace> leaves_of(const Shape& shape);

// The shape with every half-space, also in the regions of paints, replaced by map(half-space).
template <typename Map>
Shape mapped(const Shape& shape, const Map& map) {
  if (const auto* h = std::get_if<HalfSpace>(&shape.expression)) return {map(*h)};
  if (const auto* c = std::get_if<Covered>(&shape.expression))
    return covered(c->material, mapped(*c->over, map));
  if (const auto* p = std::get_if<Painted>(&shape.expression))
    return painted(p->material, mapped(*p->where, map), mapped(*p->over, map));
  std::vector<Shape> operands = operands_of(shape);
  if (operands.empty()) return shape;
  for (Shape& operand : operands) operand = mapped(operand, map);
  return with_operands(shape, std::move(operands));
}

}  // namespace groundtruth::properties
