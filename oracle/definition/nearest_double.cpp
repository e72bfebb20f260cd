#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <groundtruth/definition/nearest_double.hpp>

namespace groundtruth::definition {
namespace {

using Guess = boost::multiprecision::cpp_bin_float_100;

constexpr int least_exponent = -1074;  // of the smallest subnormal
constexpr int digits = 53;

// floor(log2(a / b)) for a, b > 0.
int binary_exponent(const Integer& a, const Integer& b) {
  const int guess = static_cast<int>(msb(a)) - static_cast<int>(msb(b));
  const bool reaches = guess >= 0 ? a >= (b << guess) : (a << -guess) >= b;
  return reaches ? guess : guess - 1;
}

// Doubles in ascending order <-> consecutive integers; both zeros are 0.
std::int64_t rank(double x) {
  const auto magnitude = std::bit_cast<std::int64_t>(std::fabs(x));
  return x < 0 ? -magnitude : magnitude;
}

double at_rank(std::int64_t r) {
  const auto magnitude = std::bit_cast<double>(r < 0 ? -r : r);
  return r < 0 ? -magnitude : magnitude;
}

Guess guess(const Real& x) {
  if (x.is_plain()) return Guess(numerator(x.plain())) / Guess(denominator(x.plain()));
  return guess(x.without_root()) + guess(x.root_factor()) * sqrt(Guess(x.radicand()));
}

int compare(const Real& x, const Rational& y) { return (x - Real(y)).sign(); }

// The rank r with at_rank(r) <= x < at_rank(r + 1). Requires |x| <= the largest double.
// The guess decides nothing: a wrong one is found out by exact comparison and costs time only.
std::int64_t rank_below(const Real& x) {
  const std::int64_t last = rank(std::numeric_limits<double>::max());
  const double near = std::clamp(guess(x).convert_to<double>(), -std::numeric_limits<double>::max(),
                                 std::numeric_limits<double>::max());
  std::int64_t low = std::max(rank(near) - 1, -last);
  std::int64_t high = std::min(rank(near) + 1, last);
  if (compare(x, rational(at_rank(low))) < 0 || compare(x, rational(at_rank(high))) >= 0) {
    low = x.sign() < 0 ? -last : 0;
    high = x.sign() < 0 ? 0 : last + 1;
  }
  while (high - low > 1) {
    const std::int64_t middle = low + (high - low) / 2;
    (compare(x, rational(at_rank(middle))) < 0 ? high : low) = middle;
  }
  return low;
}

}  // namespace

std::optional<double> nearest_double(const Rational& exact) {
  if (exact.is_zero()) return 0.0;
  const Integer top = abs(numerator(exact));
  const Integer bottom = denominator(exact);
  const int unit = std::max(binary_exponent(top, bottom) - (digits - 1), least_exponent);
  const Integer dividend = unit < 0 ? Integer(top << -unit) : top;
  const Integer divisor = unit > 0 ? Integer(bottom << unit) : bottom;
  Integer count, remainder;
  divide_qr(dividend, divisor, count, remainder);
  const int against_half = Integer(2 * remainder).compare(divisor);
  if (against_half > 0 || (against_half == 0 && bit_test(count, 0))) ++count;
  if (count.is_zero()) return 0.0;
  const double magnitude = std::ldexp(count.convert_to<double>(), unit);
  if (std::isinf(magnitude)) return std::nullopt;
  return exact.sign() < 0 ? -magnitude : magnitude;
}

std::optional<double> nearest_double(const Real& exact) {
  if (exact.is_plain()) return nearest_double(exact.plain());
  const double largest = std::numeric_limits<double>::max();
  const Rational half_unit = rational(std::ldexp(1.0, 970));
  const Real magnitude = absolute(exact);
  if (compare(magnitude, rational(largest) + half_unit) >= 0) return std::nullopt;
  if (compare(magnitude, rational(largest)) >= 0) return exact.sign() < 0 ? -largest : largest;
  const std::int64_t below = rank_below(exact);
  const Rational middle = (rational(at_rank(below)) + rational(at_rank(below + 1))) / 2;
  const int side = compare(exact, middle);
  if (side == 0) return at_rank(below % 2 == 0 ? below : below + 1);
  return at_rank(side < 0 ? below : below + 1);
}

}  // namespace groundtruth::definition
