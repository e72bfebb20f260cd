#include "number.hpp"

#include <algorithm>

namespace groundtruth::judge {
namespace {

Rational power_of_two(long exponent) {
  const Integer power = Integer(1) << static_cast<unsigned>(exponent < 0 ? -exponent : exponent);
  return exponent < 0 ? Rational(1, power) : Rational(power);
}

}  // namespace

Rational read_fraction(const std::string& text) {
  const auto slash = text.find('/');
  if (slash == std::string::npos) return Rational(Integer(text));
  return Rational(Integer(text.substr(0, slash)), Integer(text.substr(slash + 1)));
}

Rational unit_in_last_place(const Rational& value) {
  constexpr long least = -1074;
  if (value.is_zero()) return power_of_two(least);
  const Integer numerator = boost::multiprecision::abs(boost::multiprecision::numerator(value));
  const Integer denominator = boost::multiprecision::denominator(value);
  long binade = static_cast<long>(msb(numerator)) - static_cast<long>(msb(denominator));
  if (Rational(numerator, denominator) < power_of_two(binade)) --binade;
  return power_of_two(std::max(binade - 52, least));
}

}  // namespace groundtruth::judge
