#include <algorithm>
#include <memory>

#include <groundtruth/diagnosis/moves.hpp>

namespace groundtruth::diagnosis {
namespace {

using Shapes = std::vector<Shape>;

Shapes simpler(const Shape& shape);

// Without the first half, the second half, ..., a single operand: large cuts first.
std::vector<Shapes> with_fewer(const Shapes& operands) {
  std::vector<Shapes> fewer;
  for (std::size_t cut = std::max<std::size_t>(operands.size() / 2, 1); cut > 0; cut /= 2) {
    if (operands.size() / cut > 64) break;  // many small cuts of a large scene are for later rounds
    for (std::size_t first = 0; first < operands.size(); first += cut) {
      Shapes kept(operands.begin(), operands.begin() + static_cast<std::ptrdiff_t>(first));
      const std::size_t end = std::min(first + cut, operands.size());
      kept.insert(kept.end(), operands.begin() + static_cast<std::ptrdiff_t>(end), operands.end());
      fewer.push_back(std::move(kept));
    }
  }
  return fewer;
}

class Simplify {
 public:
  Shapes operator()(const Everything&) { return {}; }
  Shapes operator()(const Nothing&) { return {}; }
  Shapes operator()(const HalfSpace&) { return constants(); }
  Shapes operator()(const Union& shape) { return of_operator(shape); }
  Shapes operator()(const Intersection& shape) { return of_operator(shape); }
  Shapes operator()(const Covered& cover) {
    Shapes result{*cover.over};
    for (Shape& over : simpler(*cover.over))
      result.push_back({Covered{cover.material, std::make_shared<Shape>(std::move(over))}});
    return result;
  }
  Shapes operator()(const Painted& paint) {
    Shapes result{*paint.over, {Covered{paint.material, paint.over}}};
    for (Shape& where : simpler(*paint.where))
      result.push_back({Painted{paint.material, std::make_shared<Shape>(std::move(where)), paint.over}});
    for (Shape& over : simpler(*paint.over))
      result.push_back({Painted{paint.material, paint.where, std::make_shared<Shape>(std::move(over))}});
    return result;
  }

 private:
  static Shapes constants() { return {{Nothing{}}, {Everything{}}}; }

  template <class Operator>
  Shapes of_operator(const Operator& shape) {
    Shapes result = constants();
    if (shape.operands.size() <= 64)
      for (const Shape& operand : shape.operands) result.push_back(operand);
    for (Shapes& fewer : with_fewer(shape.operands)) result.push_back({Operator{std::move(fewer)}});
    if (shape.operands.size() > 64) return result;
    for (std::size_t i = 0; i < shape.operands.size(); ++i) {
      for (Shape& operand : simpler(shape.operands[i])) {
        Operator changed = shape;
        changed.operands[i] = std::move(operand);
        result.push_back({std::move(changed)});
      }
    }
    return result;
  }
};

Shapes simpler(const Shape& shape) { return std::visit(Simplify{}, shape.expression); }

bool bears_materials(const Shape& shape) {
  if (const auto* either = std::get_if<Union>(&shape.expression))
    return std::any_of(either->operands.begin(), either->operands.end(), bears_materials);
  if (const auto* both = std::get_if<Intersection>(&shape.expression))
    return std::any_of(both->operands.begin(), both->operands.end(), bears_materials);
  return std::holds_alternative<Covered>(shape.expression) ||
         std::holds_alternative<Painted>(shape.expression);
}

}  // namespace

Cases with_simpler_shape(const cases::Case& from) {
  Cases result;
  for (Shape& shape : simpler(from.scene.shape)) {
    result.push_back(from);
    result.back().scene.shape = std::move(shape);
    if (!bears_materials(result.back().scene.shape)) result.back().scene.materials.clear();
  }
  return result;
}

}  // namespace groundtruth::diagnosis
