#include <stdexcept>

#include <groundtruth/definition/real.hpp>

namespace groundtruth::definition {
namespace {

Integer common_denominator(const Real& x, const Integer& so_far) {
  if (x.is_plain()) return lcm(so_far, denominator(x.plain()));
  return common_denominator(x.root_factor(), common_denominator(x.without_root(), so_far));
}

Whole scaled(const Real& x, const Integer& weight) {
  return x.converted<Integer>(
      [&](const Rational& c) { return Integer(numerator(c) * (weight / denominator(c))); });
}

}  // namespace

Real square_root(const Real& square) {
  if (!square.is_plain()) throw std::logic_error("definition: a root of an irrational number");
  const Rational& value = square.plain();
  if (value.is_zero()) return 0;
  Integer radicand = numerator(value) * denominator(value);
  const unsigned halvings = static_cast<unsigned>(lsb(radicand) / 2);
  radicand /= power_of_two(2 * halvings);
  const Rational factor(power_of_two(halvings), denominator(value));
  const Integer whole_root = sqrt(radicand);
  if (whole_root * whole_root == radicand) return Rational(factor * whole_root);
  return Real::root(radicand) * factor;
}

Triple<Real> real(const Triple<Rational>& vector) { return {vector[0], vector[1], vector[2]}; }

CommonWeight over_common_weight(const Triple<Real>& first, const Triple<Real>& second) {
  Integer weight = 1;
  for (const Real& x : first) weight = common_denominator(x, weight);
  for (const Real& x : second) weight = common_denominator(x, weight);
  CommonWeight result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.first[i] = scaled(first[i], weight);
    result.second[i] = scaled(second[i], weight);
  }
  result.weight = weight;
  return result;
}

Real quotient(const Whole& number, const Integer& weight) {
  return number.converted<Rational>([&](const Integer& c) { return Rational(c, weight); });
}

}  // namespace groundtruth::definition
