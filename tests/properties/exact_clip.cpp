#include <groundtruth/tests/properties/exact_clip.hpp>

namespace groundtruth::properties {

using exact::RationalVector;
using exact::RootSum;

Tangent operator+(const Tangent& a, const Tangent& b) {
  return {a.x + b.x, a.y + b.y, a.x_weight, a.y_weight};
}
Tangent operator-(const Tangent& a, const Tangent& b) {
  return {a.x - b.x, a.y - b.y, a.x_weight, a.y_weight};
}
Rational dot(const Tangent& a, const Tangent& b) { return a.x * b.x * a.x_weight + a.y * b.y * a.y_weight; }

ExactCase::ExactCase(const ClipAsk& ask)
    : ExactCase(exact::to_rational(ask.force_in_wheel), exact::to_rational(ask.normal_in_wheel),
                {Rational(ask.friction), Rational(ask.brake)}) {}

ExactCase::ExactCase(const RationalVector& force, const RationalVector& normal,
                     const exact::PebbleBorder& border)
    : force_(force), normal_(normal), border_(border), clip_(exact::clip_force(force, normal, border)) {}

RationalVector ExactCase::y_axis() const {
  const RationalVector& n = normal_;
  return {-n.x() * n.y(), n.x() * n.x() + n.z() * n.z(), -n.y() * n.z()};
}

Tangent ExactCase::tangent(const Rational& x, const Rational& y) const {
  const Rational r_squared = x_axis() * x_axis();
  return {x, y, 1 / r_squared, 1 / (r_squared * (normal_ * normal_))};
}

Tangent ExactCase::clipped(unsigned bits) const {
  const auto components = force_in_wheel();
  std::array<Rational, 3> values;
  for (std::size_t i = 0; i < 3; ++i) values[i] = components[i].enclosure(bits)[0];
  return seen({values[0], values[1], values[2]});
}

Tangent ExactCase::drawn_into_border(const Tangent& aim) const {
  Tangent drawn = aim;
  const auto is_outside = [&] {
    return drawn.along_x_squared() > brake_squared() || drawn.squared() > disc_squared();
  };
  if (!is_outside()) return drawn;
  Rational inside = 0, outside = 1;
  for (int halvings = 0; halvings < 40; ++halvings) {
    const Rational middle = (inside + outside) / 2;
    drawn = tangent(aim.x * middle, aim.y * middle);
    (is_outside() ? outside : inside) = middle;
  }
  return tangent(aim.x * inside, aim.y * inside);
}

bool ExactCase::normal_part_is_kept() const {
  const auto [x, y, z] = force_in_wheel();
  const RootSum along = x * normal_.x() + y * normal_.y() + z * normal_.z();
  return sign(along - RootSum(force_ * normal_)) == 0;
}

ExactCase ExactCase::pushed(const Rational& x, const Rational& y) const {
  return {force_ + x_axis() * x + y_axis() * y, normal_, border_};
}

ExactCase ExactCase::with_opposite_tangential_part() const {
  return {normal_part() * Rational(2) - force_, normal_, border_};
}

bool ExactCase::clips_opposite_to(const ExactCase& other) const {
  const auto here = force_in_wheel(), there = other.force_in_wheel();
  const RationalVector twice = normal_part() * Rational(2);
  const std::array<Rational, 3> expected{twice.x(), twice.y(), twice.z()};
  for (std::size_t i = 0; i < 3; ++i)
    if (sign(here[i] + there[i] - RootSum(expected[i])) != 0) return false;
  return clip_.grip == other.clip_.grip;
}

Rational ExactCase::disc_squared() const {
  const Rational along = force_ * normal_;
  return border_.friction * border_.friction * along * along / (normal_ * normal_);
}

Rational ExactCase::scale_squared() const {
  const Rational axes = x_axis() * x_axis() + y_axis() * y_axis();
  const Tangent unit = tangent(1, 1);
  const Rational numbers = 1 + force_ * force_ + brake_squared() + disc_squared();
  return numbers * (1 + axes) * (1 + unit.squared());
}

}  // namespace groundtruth::properties
