#include <groundtruth/exact/arithmetic/rounding.hpp>

#include <cmath>
#include <limits>

namespace groundtruth::exact {
namespace {

namespace mp = boost::multiprecision;

constexpr int mantissa_bits = std::numeric_limits<double>::digits;                 // 53
constexpr long smallest_exponent = std::numeric_limits<double>::min_exponent - 1;  // -1022
constexpr double infinity = std::numeric_limits<double>::infinity();

Integer power_of_two(unsigned long exponent) { return Integer(1) << exponent; }

// n/d * 2^shift as a fraction.
void shift_by(Integer& numerator, Integer& denominator, long shift) {
  if (shift > 0) numerator <<= static_cast<unsigned long>(shift);
  if (shift < 0) denominator <<= static_cast<unsigned long>(-shift);
}

// floor(log2(n/d)), both positive.
long floor_log2(const Integer& numerator, const Integer& denominator) {
  const long guess = static_cast<long>(mp::msb(numerator)) - static_cast<long>(mp::msb(denominator));
  Integer n = numerator;
  Integer d = denominator;
  shift_by(n, d, -guess);
  return n >= d ? guess : guess - 1;
}

double nearest_positive_double(Integer numerator, Integer denominator) {
  const long exponent = std::max(floor_log2(numerator, denominator), smallest_exponent);
  const long last_bit = exponent - (mantissa_bits - 1);
  shift_by(numerator, denominator, -last_bit);
  Integer quotient;
  Integer remainder;
  mp::divide_qr(numerator, denominator, quotient, remainder);
  const int against_half = Integer(2 * remainder).compare(denominator);
  if (against_half > 0 || (against_half == 0 && mp::bit_test(quotient, 0))) ++quotient;
  // At most 2^53: exact. Past the largest exponent ldexp gives infinity, which is IEEE's rounding.
  return std::ldexp(quotient.convert_to<double>(), static_cast<int>(last_bit));
}

// Halfway between neighbouring doubles; the larger magnitude may be infinity, which then stands for 2^1024.
Rational midpoint(double left, double right) {
  const Rational beyond(power_of_two(1024));
  const auto exact = [&](double value) -> Rational {
    if (std::isinf(value)) return value > 0 ? beyond : Rational(-beyond);
    return Rational(value);
  };
  return (exact(left) + exact(right)) / 2;
}

Rational power_of_ten(long exponent) {
  const Integer power = mp::pow(Integer(10), static_cast<unsigned>(std::labs(exponent)));
  return exponent < 0 ? Rational(Integer(1), power) : Rational(power);
}

Integer floor_of(const Rational& value) {
  Integer quotient;
  Integer remainder;
  mp::divide_qr(Integer(mp::numerator(value)), Integer(mp::denominator(value)), quotient, remainder);
  if (remainder < 0) --quotient;
  return quotient;
}

// An integer n such that 10^n <= |value|, the largest or one less. Requires value != 0.
long floor_log10(const RootSum& value) {
  for (unsigned bits = 64;; bits *= 2) {
    const auto [lower, upper] = value.enclosure(bits);
    if (sign(lower) != sign(upper)) continue;
    const Rational magnitude = sign(lower) > 0 ? lower : Rational(-upper);
    const long log2 = floor_log2(mp::numerator(magnitude), mp::denominator(magnitude));
    long log10 = static_cast<long>(std::floor(static_cast<double>(log2) * 0.30102999566398)) - 1;
    while (power_of_ten(log10 + 1) <= magnitude) ++log10;
    return log10;
  }
}

std::string decimal(const Integer& digits, long exponent) {
  return digits.str() + (exponent == 0 ? "" : "e" + std::to_string(exponent));
}

}  // namespace

double nearest_double(const Rational& value) {
  if (value.is_zero()) return 0;
  const double magnitude =
      nearest_positive_double(Integer(mp::abs(mp::numerator(value))), Integer(mp::denominator(value)));
  if (magnitude == 0) return 0;
  return sign(value) > 0 ? magnitude : -magnitude;
}

double nearest_double(const RootSum& value) {
  if (value.is_rational()) return nearest_double(value.rational_part());
  if (sign(value) == 0) return 0;
  for (unsigned bits = 128;; bits *= 2) {
    const auto [lower, upper] = value.enclosure(bits);
    const double below = nearest_double(lower);
    const double above = nearest_double(upper);
    if (below == above) return below;
    if (std::nextafter(below, infinity) != above) continue;
    // What no enclosure could ever settle, a tie, the sign does.
    const Rational middle = midpoint(below, above);
    const int side = sign(value - RootSum(middle));
    if (side != 0) return side < 0 ? below : above;
    return nearest_double(middle);
  }
}

Enclosure decimal_enclosure(std::string quantity, const RootSum& value, unsigned digits) {
  if (sign(value) == 0) return {std::move(quantity), "0", "0"};
  const long exponent = floor_log10(value) - static_cast<long>(digits) + 1;
  const Rational unit = power_of_ten(exponent);
  for (unsigned bits = 64;; bits *= 2) {
    const auto [lower, upper] = value.enclosure(bits);
    const Integer below = floor_of(lower / unit);
    for (const Integer& candidate : {below, Integer(below + 1)}) {
      if (sign(value - RootSum(Rational(candidate) * unit)) == 0) {
        const std::string text = decimal(candidate, exponent);
        return {std::move(quantity), text, text};
      }
    }
    if (floor_of(upper / unit) == below) {
      return {std::move(quantity), decimal(below, exponent), decimal(Integer(below + 1), exponent)};
    }
  }
}

}  // namespace groundtruth::exact
