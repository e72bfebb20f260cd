#include <groundtruth/tests/properties/rewrites.hpp>

namespace groundtruth::properties {
namespace {

// Rewrites an operation's operands, which are rewritten themselves, with change(operands). `next_leaf` is the
// number of the shape's first leaf in the original.
template <typename Change>
Rewritten rewritten(const Shape& shape, const Change& change, Leaf& next_leaf) {
  if (std::holds_alternative<HalfSpace>(shape.expression)) return {shape, {next_leaf++}};
  if (const auto* c = std::get_if<Covered>(&shape.expression)) {
    Rewritten over = rewritten(*c->over, change, next_leaf);
    return {covered(c->material, std::move(over.shape)), std::move(over.old_leaf)};
  }
  if (const auto* p = std::get_if<Painted>(&shape.expression)) {
    Rewritten over = rewritten(*p->over, change, next_leaf);
    return {painted(p->material, *p->where, std::move(over.shape)), std::move(over.old_leaf)};
  }
  std::vector<Rewritten> operands;
  for (const Shape& operand : operands_of(shape)) operands.push_back(rewritten(operand, change, next_leaf));
  if (operands.empty()) return {shape, {}};
  change(operands);
  std::vector<Shape> shapes;
  std::vector<Leaf> old_leaf;
  for (Rewritten& operand : operands) {
    shapes.push_back(std::move(operand.shape));
    old_leaf.insert(old_leaf.end(), operand.old_leaf.begin(), operand.old_leaf.end());
  }
  return {with_operands(shape, std::move(shapes)), std::move(old_leaf)};
}

}  // namespace

Rewritten with_operands_permuted(const Shape& shape, Dice& dice) {
  Leaf next_leaf = 0;
  return rewritten(
      shape, [&dice](std::vector<Rewritten>& operands) { dice.shuffle(operands); }, next_leaf);
}

Rewritten with_operands_duplicated(const Shape& shape, Dice& dice) {
  Leaf next_leaf = 0;
  const auto duplicate = [&dice](std::vector<Rewritten>& operands) {
    for (int copies = dice.whole(0, 2); copies > 0; --copies) {
      const Rewritten copy = dice.pick(operands);
      const auto place = dice.whole(0, static_cast<int>(operands.size()));
      operands.insert(operands.begin() + place, copy);
    }
  };
  return rewritten(shape, duplicate, next_leaf);
}

Shape flattened(const Shape& shape) {
  if (const auto* c = std::get_if<Covered>(&shape.expression))
    return covered(c->material, flattened(*c->over));
  if (const auto* p = std::get_if<Painted>(&shape.expression))
    return painted(p->material, flattened(*p->where), flattened(*p->over));
  if (operands_of(shape).empty()) return shape;
  std::vector<Shape> flat;
  for (const Shape& operand : operands_of(shape)) {
    const Shape part = flattened(operand);
    const std::vector<Shape> grandchildren = operands_of(part);
    const bool same_operation = part.expression.index() == shape.expression.index();
    if (same_operation) flat.insert(flat.end(), grandchildren.begin(), grandchildren.end());
    if (!same_operation) flat.push_back(part);
  }
  return with_operands(shape, std::move(flat));
}

}  // namespace groundtruth::properties
