#include "rewrite.hpp"

#include <memory>

namespace groundtruth::planted {
namespace {

struct Rewrite {
  const Change& change;
  unsigned depth;

  Shape operator()(const Everything& shape) const { return {shape}; }
  Shape operator()(const Nothing& shape) const { return {shape}; }
  Shape operator()(const HalfSpace& shape) const { return {shape}; }
  Shape operator()(const Union& shape) const { return {Union{all(shape.operands)}}; }
  Shape operator()(const Intersection& shape) const { return {Intersection{all(shape.operands)}}; }
  Shape operator()(const Covered& shape) const { return {Covered{shape.material, over(*shape.over)}}; }
  Shape operator()(const Painted& shape) const {
    return {Painted{shape.material, shape.where, over(*shape.over)}};
  }

  std::shared_ptr<const Shape> over(const Shape& shape) const {
    return std::make_shared<const Shape>(rewritten(shape, change, depth));
  }
  std::vector<Shape> all(const std::vector<Shape>& shapes) const {
    std::vector<Shape> changed;
    for (const Shape& shape : shapes) changed.push_back(rewritten(shape, change, depth + 1));
    return changed;
  }
};

}  // namespace

Shape rewritten(const Shape& shape, const Change& change, unsigned depth) {
  return change(std::visit(Rewrite{change, depth}, shape.expression), depth);
}

Scene with_half_spaces(Scene scene, HalfSpace (*change)(HalfSpace)) {
  scene.shape = rewritten(scene.shape, [change](Shape shape, unsigned) {
    auto* half_space = std::get_if<HalfSpace>(&shape.expression);
    return half_space ? Shape{change(*half_space)} : shape;
  });
  return scene;
}

Shape as_nothing(Shape shape) { return {Intersection{{{Nothing{}}, std::move(shape)}}}; }
Shape as_everything(Shape shape) { return {Union{{{Everything{}}, std::move(shape)}}}; }

}  // namespace groundtruth::planted
