#include <groundtruth/tests/properties/shapes.hpp>

namespace groundtruth::properties {
namespace {

void append_leaves(const Shape& shape, std::vector<HalfSpace>& leaves) {
  if (const auto* h = std::get_if<HalfSpace>(&shape.expression)) leaves.push_back(*h);
  if (const auto* c = std::get_if<Covered>(&shape.expression)) append_leaves(*c->over, leaves);
  if (const auto* p = std::get_if<Painted>(&shape.expression)) append_leaves(*p->over, leaves);
  for (const Shape& operand : operands_of(shape)) append_leaves(operand, leaves);
}

}  // namespace

std::vector<Shape> operands_of(const Shape& shape) {
  if (const auto* u = std::get_if<Union>(&shape.expression)) return u->operands;
  if (const auto* i = std::get_if<Intersection>(&shape.expression)) return i->operands;
  return {};
}

Shape with_operands(const Shape& shape, std::vector<Shape> operands) {
  const bool united = std::holds_alternative<Union>(shape.expression);
  return united ? any_of(std::move(operands)) : all_of(std::move(operands));
}

std::vector<HalfSpace> leaves_of(const Shape& shape) {
  std::vector<HalfSpace> leaves;
  append_leaves(shape, leaves);
  return leaves;
}

}  // namespace groundtruth::properties
