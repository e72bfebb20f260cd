#include <groundtruth/exact/solid/solid.hpp>

namespace groundtruth::exact {
namespace {

class Layout {
 public:
  explicit Layout(std::vector<Layer>& layers) : layers_(layers) {}

  Solid lay_out(const Shape& shape) {
    append(shape);
    return std::move(solid_);
  }

  void operator()(const Everything&) { append(Operation::everything); }
  void operator()(const Nothing&) { append(Operation::nothing); }
  void operator()(const HalfSpace& half_space) {
    append(Operation::leaf, solid_.half_spaces.size());
    solid_.half_spaces.push_back(half_space);
  }
  void operator()(const Union& united) { append(Operation::united, united.operands); }
  void operator()(const Intersection& intersected) { append(Operation::intersected, intersected.operands); }
  void operator()(const Covered& covered) { append_layer({covered.material, {}}, *covered.over); }
  void operator()(const Painted& painted) {
    std::vector<Layer> paint_is_not_painted;
    append_layer({painted.material, Layout(paint_is_not_painted).lay_out(*painted.where)}, *painted.over);
  }

 private:
  void append(const Shape& shape) { std::visit(*this, shape.expression); }

  void append(Operation operation, Leaf leaf = 0) {
    solid_.expression.push_back({operation, solid_.expression.size() + 1, leaf});
  }

  void append(Operation operation, const std::vector<Shape>& operands) {
    const std::size_t at = solid_.expression.size();
    append(operation);
    for (const Shape& operand : operands) append(operand);
    solid_.expression[at].end = solid_.expression.size();
  }

  void append_layer(Layer layer, const Shape& over) {
    const std::size_t at = layers_.size();
    layer.first_leaf = solid_.half_spaces.size();
    layers_.push_back(std::move(layer));
    append(over);
    layers_[at].end_leaf = solid_.half_spaces.size();
  }

  Solid solid_;
  std::vector<Layer>& layers_;
};

}  // namespace

Ground lay_out(const groundtruth::Scene& scene) {
  Ground ground;
  ground.solid = Layout(ground.layers).lay_out(scene.shape);
  ground.materials = scene.materials;
  return ground;
}

}  // namespace groundtruth::exact
