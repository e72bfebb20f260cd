#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <groundtruth/cases/scene_builders.hpp>
#include <groundtruth/cases/shape_parts.hpp>
#include <groundtruth/cases/vector_arithmetic.hpp>

namespace groundtruth::cases {
namespace {

Shape shifted_shape(const Shape& shape, const Vector& offset);

std::vector<Shape> shifted_operands(const std::vector<Shape>& operands, const Vector& offset) {
  std::vector<Shape> result;
  result.reserve(operands.size());
  for (const Shape& operand : operands) result.push_back(shifted_shape(operand, offset));
  return result;
}

Shape shifted_shape(const Shape& shape, const Vector& offset) {
  return std::visit(
      [&](const auto& expression) -> Shape {
        using Expression = std::decay_t<decltype(expression)>;
        if constexpr (std::is_same_v<Expression, HalfSpace>) {
          return {HalfSpace{expression.normal, expression.offset + dot(expression.normal, offset)}};
        } else if constexpr (std::is_same_v<Expression, Union> || std::is_same_v<Expression, Intersection>) {
          return {Expression{shifted_operands(expression.operands, offset)}};
        } else if constexpr (std::is_same_v<Expression, Covered>) {
          return covered(expression.material, shifted_shape(*expression.over, offset));
        } else if constexpr (std::is_same_v<Expression, Painted>) {
          return painted(expression.material, shifted_shape(*expression.where, offset),
                         shifted_shape(*expression.over, offset));
        } else {
          return {expression};
        }
      },
      shape.expression);
}

}  // namespace

Scene shifted(const Scene& scene, const Vector& offset) {
  return {scene.materials, shifted_shape(scene.shape, offset)};
}

}  // namespace groundtruth::cases
