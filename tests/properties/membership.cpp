#include <algorithm>

#include <groundtruth/tests/properties/membership.hpp>

namespace groundtruth::properties {

Point point(const Vector& vector) { return {Rational(vector[0]), Rational(vector[1]), Rational(vector[2])}; }

Point point_at(const EntryAsk& ask, const Rational& lambda) {
  Point result = point(ask.from);
  for (std::size_t i = 0; i < 3; ++i) result[i] += lambda * (Rational(ask.to[i]) - Rational(ask.from[i]));
  return result;
}

Rational delta(const HalfSpace& h, const Point& x) {
  return Rational(h.normal[0]) * x[0] + Rational(h.normal[1]) * x[1] + Rational(h.normal[2]) * x[2] -
         Rational(h.offset);
}

bool contains(const Shape& shape, const Point& x) {
  const auto contains_x = [&](const Shape& operand) { return contains(operand, x); };
  if (std::holds_alternative<Everything>(shape.expression)) return true;
  if (std::holds_alternative<Nothing>(shape.expression)) return false;
  if (const auto* h = std::get_if<HalfSpace>(&shape.expression)) return delta(*h, x) <= 0;
  if (const auto* c = std::get_if<Covered>(&shape.expression)) return contains(*c->over, x);
  if (const auto* p = std::get_if<Painted>(&shape.expression)) return contains(*p->over, x);
  if (const auto* u = std::get_if<Union>(&shape.expression))
    return std::any_of(u->operands.begin(), u->operands.end(), contains_x);
  const auto& intersection = std::get<Intersection>(shape.expression);
  return std::all_of(intersection.operands.begin(), intersection.operands.end(), contains_x);
}

std::optional<MaterialIndex> material_of(const Shape& shape, Leaf leaf, const Point& x) {
  if (const auto* c = std::get_if<Covered>(&shape.expression)) return c->material;
  if (const auto* p = std::get_if<Painted>(&shape.expression))
    return contains(*p->where, x) ? p->material : material_of(*p->over, leaf, x);
  for (const Shape& operand : operands_of(shape)) {
    const std::size_t count = leaves_of(operand).size();
    if (leaf < count) return material_of(operand, leaf, x);
    leaf -= count;
  }
  return std::nullopt;
}

}  // namespace groundtruth::properties
