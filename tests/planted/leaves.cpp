#include "leaves.hpp"

#include <algorithm>

namespace groundtruth::planted {
namespace {

class Collect {
 public:
  void from(const Shape& shape) {
    around_.push_back(&shape);
    std::visit([this](const auto& expression) { from(expression); }, shape.expression);
    around_.pop_back();
  }
  std::vector<PlacedLeaf> leaves;

 private:
  void from(const Everything&) {}
  void from(const Nothing&) {}
  void from(const HalfSpace& half_space) { leaves.push_back({half_space, around_}); }
  void from(const Union& shape) { from(shape.operands); }
  void from(const Intersection& shape) { from(shape.operands); }
  void from(const Covered& shape) { from(*shape.over); }
  void from(const Painted& shape) { from(*shape.over); }
  void from(const std::vector<Shape>& operands) {
    for (const Shape& operand : operands) from(operand);
  }

  std::vector<const Shape*> around_;
};

}  // namespace

std::vector<PlacedLeaf> leaves_of(const Shape& shape) {
  Collect collect;
  collect.from(shape);
  return std::move(collect.leaves);
}

int side_of(const HalfSpace& half_space, const Place& point) {
  Rational height = -Rational(half_space.offset);
  for (std::size_t axis = 0; axis < 3; ++axis) height += Rational(half_space.normal[axis]) * point[axis];
  return height.sign();
}

bool contains(const Shape& shape, const Place& point) {
  const auto holds_it = [&](const Shape& operand) { return contains(operand, point); };
  struct Holds {
    const Place& point;
    const decltype(holds_it)& operand_holds_it;
    bool operator()(const Everything&) const { return true; }
    bool operator()(const Nothing&) const { return false; }
    bool operator()(const HalfSpace& half_space) const { return side_of(half_space, point) <= 0; }
    bool operator()(const Union& shape) const {
      return std::any_of(shape.operands.begin(), shape.operands.end(), operand_holds_it);
    }
    bool operator()(const Intersection& shape) const {
      return std::all_of(shape.operands.begin(), shape.operands.end(), operand_holds_it);
    }
    bool operator()(const Covered& shape) const { return contains(*shape.over, point); }
    bool operator()(const Painted& shape) const { return contains(*shape.over, point); }
  };
  return std::visit(Holds{point, holds_it}, shape.expression);
}

std::optional<MaterialIndex> material_of(const PlacedLeaf& leaf, const Place& point) {
  for (const Shape* shape : leaf.around) {
    if (const auto* covered = std::get_if<Covered>(&shape->expression)) return covered->material;
    const auto* painted = std::get_if<Painted>(&shape->expression);
    if (painted != nullptr && contains(*painted->where, point)) return painted->material;
  }
  return std::nullopt;
}

}  // namespace groundtruth::planted
