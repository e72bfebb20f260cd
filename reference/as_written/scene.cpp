#include <groundtruth/as_written/scene.hpp>
#include <groundtruth/as_written/vector_algebra.hpp>

#include <utility>
#include <variant>

namespace groundtruth::as_written {
namespace {

struct Layout {
  Expression expression;
  std::vector<Paint> paints;
  std::vector<std::optional<std::size_t>> innermost_paint;
};

// Lays a shape out, operand by operand. Numbers the leaves of whatever it is given: of a paint's region those
// numbers, and the paints, mean nothing and are dropped.
class Layer {
 public:
  explicit Layer(Layout& layout) : layout_(layout) {}

  void lay(const Shape& shape) {
    std::visit([this](const auto& expression) { lay_expression(expression); }, shape.expression);
  }

 private:
  void lay_expression(const Everything&) { lay_constant(Operation::everything); }
  void lay_expression(const Nothing&) { lay_constant(Operation::nothing); }
  void lay_expression(const Union& shape) { lay_operands(Operation::union_of, shape.operands); }
  void lay_expression(const Intersection& shape) { lay_operands(Operation::intersection_of, shape.operands); }

  void lay_expression(const HalfSpace& half_space) {
    const Leaf leaf = layout_.innermost_paint.size();
    layout_.innermost_paint.push_back(innermost_);
    if (is_zero(half_space.normal)) {
      lay_constant(half_space.offset >= 0 ? Operation::everything : Operation::nothing);
    } else {
      layout_.expression.push_back({Operation::half_space, layout_.expression.size() + 1, half_space, leaf});
    }
  }

  void lay_expression(const Covered& shape) {
    lay_under({shape.material, {{Operation::everything, 1, {}, 0}}, innermost_}, *shape.over);
  }

  void lay_expression(const Painted& shape) {
    Layout region;
    Layer(region).lay(*shape.where);
    lay_under({shape.material, std::move(region.expression), innermost_}, *shape.over);
  }

  void lay_under(Paint paint, const Shape& shape) {
    const std::optional<std::size_t> outer = innermost_;
    innermost_ = layout_.paints.size();
    layout_.paints.push_back(std::move(paint));
    lay(shape);
    innermost_ = outer;
  }

  void lay_constant(Operation operation) {
    layout_.expression.push_back({operation, layout_.expression.size() + 1, {}, 0});
  }

  void lay_operands(Operation operation, const std::vector<Shape>& operands) {
    const std::size_t place = layout_.expression.size();
    layout_.expression.push_back({operation, 0, {}, 0});
    for (const Shape& operand : operands) {
      lay(operand);
    }
    layout_.expression[place].end = layout_.expression.size();
  }

  Layout& layout_;
  std::optional<std::size_t> innermost_;
};

}  // namespace

Scene::Scene(const groundtruth::Scene& scene) : materials_(scene.materials) {
  Layout layout;
  Layer(layout).lay(scene.shape);
  solid_ = std::move(layout.expression);
  paints_ = std::move(layout.paints);
  innermost_paint_ = std::move(layout.innermost_paint);
}

}  // namespace groundtruth::as_written
