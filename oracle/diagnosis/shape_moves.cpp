#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

#include <groundtruth/diagnosis/moves.hpp>

namespace groundtruth::diagnosis {
namespace {

using Shapes = std::vector<Shape>;
using TakeShape = std::function<bool(Shape&&)>;

bool simpler(const Shape& shape, const TakeShape& take);

// A longer list is halved rather than tried operand by operand.
constexpr std::size_t long_list = 64;

Shapes without(const Shapes& operands, std::size_t first, std::size_t count) {
  const auto from = operands.begin() + static_cast<std::ptrdiff_t>(first);
  const auto to = operands.begin() + static_cast<std::ptrdiff_t>(std::min(first + count, operands.size()));
  Shapes kept(operands.begin(), from);
  kept.insert(kept.end(), to, operands.end());
  return kept;
}

class Simplify {
 public:
  explicit Simplify(const TakeShape& take) : take_(take) {}

  bool operator()(const Everything&) { return true; }
  bool operator()(const Nothing&) { return true; }
  bool operator()(const HalfSpace&) { return take_({Nothing{}}) && take_({Everything{}}); }
  bool operator()(const Union& shape) { return of_operator(shape); }
  bool operator()(const Intersection& shape) { return of_operator(shape); }
  bool operator()(const Covered& cover) {
    return take_(Shape(*cover.over)) && simpler(*cover.over, [&](Shape&& over) {
             return take_({Covered{cover.material, std::make_shared<Shape>(std::move(over))}});
           });
  }
  bool operator()(const Painted& paint) {
    return take_(Shape(*paint.over)) && take_({Covered{paint.material, paint.over}}) &&
           simpler(*paint.where,
                   [&](Shape&& where) {
                     return take_(
                         {Painted{paint.material, std::make_shared<Shape>(std::move(where)), paint.over}});
                   }) &&
           simpler(*paint.over, [&](Shape&& over) {
             return take_({Painted{paint.material, paint.where, std::make_shared<Shape>(std::move(over))}});
           });
  }

 private:
  template <class Operator>
  bool of_operator(const Operator& shape) {
    const Shapes& operands = shape.operands;
    if (!take_({Nothing{}}) || !take_({Everything{}})) return false;
    if (operands.size() <= long_list)
      for (const Shape& operand : operands)
        if (!take_(Shape(operand))) return false;
    // Halves first, then quarters, ..., single operands.
    for (std::size_t cut = std::max<std::size_t>(operands.size() / 2, 1); cut > 0; cut /= 2)
      for (std::size_t first = 0; first < operands.size(); first += cut)
        if (!take_({Operator{without(operands, first, cut)}})) return false;
    for (std::size_t i = 0; i < operands.size(); ++i) {
      const auto take_changed = [&](Shape&& operand) {
        Operator changed = shape;
        changed.operands[i] = std::move(operand);
        return take_({std::move(changed)});
      };
      if (!simpler(operands[i], take_changed)) return false;
    }
    return true;
  }

  const TakeShape& take_;
};

bool simpler(const Shape& shape, const TakeShape& take) {
  return std::visit(Simplify{take}, shape.expression);
}

bool bears_materials(const Shape& shape) {
  if (const auto* either = std::get_if<Union>(&shape.expression))
    return std::any_of(either->operands.begin(), either->operands.end(), bears_materials);
  if (const auto* both = std::get_if<Intersection>(&shape.expression))
    return std::any_of(both->operands.begin(), both->operands.end(), bears_materials);
  return std::holds_alternative<Covered>(shape.expression) ||
         std::holds_alternative<Painted>(shape.expression);
}

}  // namespace

bool with_simpler_shape(const cases::Case& from, const Take& take) {
  const bool bears = !from.scene.materials.empty();
  return simpler(from.scene.shape, [&](Shape&& shape) {
    std::vector<Material> materials;
    if (bears && bears_materials(shape)) materials = from.scene.materials;
    return take({from.id, {std::move(materials), std::move(shape)}, from.ask, from.flags, from.note});
  });
}

}  // namespace groundtruth::diagnosis
