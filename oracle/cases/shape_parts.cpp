#include <memory>
#include <type_traits>
#include <utility>
#include <variant>

#include <groundtruth/cases/shape_parts.hpp>

namespace groundtruth::cases {

Shape half_space(double nx, double ny, double nz, double offset) { return {HalfSpace{{nx, ny, nz}, offset}}; }

Shape box(const Vector& low, const Vector& high) {
  // 0 - low rather than -low: no negative zeros.
  return intersection_of({half_space(-1, 0, 0, 0 - low[0]), half_space(1, 0, 0, high[0]),
                          half_space(0, -1, 0, 0 - low[1]), half_space(0, 1, 0, high[1]),
                          half_space(0, 0, -1, 0 - low[2]), half_space(0, 0, 1, high[2])});
}

Shape union_of(std::vector<Shape> operands) { return {Union{std::move(operands)}}; }

Shape intersection_of(std::vector<Shape> operands) { return {Intersection{std::move(operands)}}; }

Shape covered(MaterialIndex material, Shape over) {
  return {Covered{material, std::make_shared<const Shape>(std::move(over))}};
}

Shape painted(MaterialIndex material, Shape where, Shape over) {
  return {Painted{material, std::make_shared<const Shape>(std::move(where)),
                  std::make_shared<const Shape>(std::move(over))}};
}

Shape with_each_plane(const Shape& shape, const std::function<HalfSpace(const HalfSpace&)>& replacement) {
  return std::visit(
      [&](const auto& expression) -> Shape {
        using Expression = std::decay_t<decltype(expression)>;
        if constexpr (std::is_same_v<Expression, HalfSpace>) {
          return {replacement(expression)};
        } else if constexpr (std::is_same_v<Expression, Union> || std::is_same_v<Expression, Intersection>) {
          std::vector<Shape> operands;
          operands.reserve(expression.operands.size());
          for (const Shape& operand : expression.operands) {
            operands.push_back(with_each_plane(operand, replacement));
          }
          return {Expression{std::move(operands)}};
        } else if constexpr (std::is_same_v<Expression, Covered>) {
          return covered(expression.material, with_each_plane(*expression.over, replacement));
        } else if constexpr (std::is_same_v<Expression, Painted>) {
          Shape where = with_each_plane(*expression.where, replacement);
          return painted(expression.material, std::move(where),
                         with_each_plane(*expression.over, replacement));
        } else {
          return {expression};
        }
      },
      shape.expression);
}

std::size_t leaf_count(const Shape& shape) {
  return std::visit(
      [](const auto& expression) -> std::size_t {
        using Expression = std::decay_t<decltype(expression)>;
        if constexpr (std::is_same_v<Expression, HalfSpace>) {
          return 1;
        } else if constexpr (std::is_same_v<Expression, Union> || std::is_same_v<Expression, Intersection>) {
          std::size_t sum = 0;
          for (const Shape& operand : expression.operands) sum += leaf_count(operand);
          return sum;
        } else if constexpr (std::is_same_v<Expression, Covered> || std::is_same_v<Expression, Painted>) {
          return leaf_count(*expression.over);
        } else {
          return 0;
        }
      },
      shape.expression);
}

}  // namespace groundtruth::cases
