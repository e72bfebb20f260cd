#include <groundtruth/fast/exact_stage/rounding.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace groundtruth::fast::exact_stage {

namespace {

constexpr int least_exponent = -1074;  // of a double's last place
constexpr double largest = std::numeric_limits<double>::max();

int bits_of(const Integer& positive) { return static_cast<int>(boost::multiprecision::msb(positive)) + 1; }

// The double nearest to (quotient + something in (0, 1) if there is a rest) * 2^exponent. Requires a quotient
// of at least 55 bits, whose last is not yet the half of a double's last place.
enum class Rest { none, some };
std::optional<double> round(const Integer& quotient, Rest rest, int exponent) {
  const int bits = bits_of(quotient);
  const int dropped = std::max(bits - 53, least_exponent - exponent);
  if (dropped > bits) return 0.0;
  Integer kept = quotient >> dropped;
  const Integer below = quotient - (kept << dropped), half = Integer(1) << (dropped - 1);
  const int against_half = below.compare(half);
  const bool is_above = against_half > 0 || (against_half == 0 && rest == Rest::some);
  if (is_above || (against_half == 0 && boost::multiprecision::bit_test(kept, 0))) ++kept;
  const double result = std::ldexp(static_cast<double>(static_cast<std::uint64_t>(kept)), exponent + dropped);
  return result <= largest ? std::optional(result) : std::nullopt;
}

std::optional<double> negated(const std::optional<double>& x) {
  return x && *x != 0 ? std::optional(-*x) : x;
}

// floor(sqrt(x)). Newton's method from above falls until it is there; Boost's goes bit by bit.
Integer floor_of_root(const Integer& x) {
  const int dropped = std::max(0, bits_of(x) - 62) / 2 * 2;
  const auto leading = static_cast<double>(static_cast<std::uint64_t>(Integer(x >> dropped)));
  const auto above = static_cast<std::uint64_t>(std::sqrt(leading) * (1 + 0x1p-50)) + 2;
  Integer root = Integer(above) << (dropped / 2);
  for (;;) {
    Integer next = (root + x / root) >> 1;
    if (next >= root) return root;
    root = next;
  }
}

// sqrt(x) lies in [low, high], which are equal only if they are the root; some `bits` bits of it are known.
struct RootBounds {
  Dyadic low;
  Dyadic high;
};
RootBounds root_bounds(const Dyadic& x, int bits) {
  if (x.sign() == 0) return {};
  int shift = 2 * bits - bits_of(x.mantissa());
  if ((x.exponent() - shift) % 2 != 0) ++shift;
  const Integer scaled = shift >= 0 ? x.mantissa() << shift : x.mantissa() >> -shift;
  const Integer root = floor_of_root(scaled);
  const int exponent = (x.exponent() - shift) / 2;
  const Dyadic low(root, exponent);
  const bool is_exact = root * root == scaled && (shift >= 0 || scaled << -shift == x.mantissa());
  return {low, is_exact ? low : Dyadic(root + 1, exponent)};
}

RootBounds product_bounds(const Dyadic& factor, const RootBounds& root) {
  RootBounds bounds{factor * root.low, factor * root.high};
  if (factor.sign() < 0) std::swap(bounds.low, bounds.high);
  return bounds;
}

RootBounds bounds_of(const Surd& x, const Radicands& roots, int bits) {
  const RootBounds first = product_bounds(x.of_first, root_bounds(roots.first, bits));
  const RootBounds second = product_bounds(x.of_second, root_bounds(roots.second, bits));
  return {x.rational + first.low + second.low, x.rational + first.high + second.high};
}

// Is the distance of the bounds less than 2^-60 of them? Requires low > 0.
bool is_narrow(const RootBounds& bounds) {
  const Dyadic distance = bounds.high - bounds.low;
  return distance.sign() == 0 || (bounds.low - distance.scaled(60)).sign() > 0;
}

Dyadic as_dyadic(const std::optional<double>& x) { return x ? Dyadic(*x) : Dyadic(Integer(1), 1024); }

std::optional<double> nearest_to_positive(const Surd& numerator, const Radicands& roots,
                                          const Dyadic& denominator) {
  RootBounds bounds;
  int bits = 128;
  do {
    bounds = bounds_of(numerator, roots, bits);
    bits *= 2;
  } while (bounds.low.sign() <= 0 || !is_narrow(bounds));
  const auto low = nearest_double(bounds.low, denominator);
  const auto high = nearest_double(bounds.high, denominator);
  if (low == high) return low;
  const Dyadic middle = (as_dyadic(low) + as_dyadic(high)).scaled(-1);
  const int side = sign(numerator - Surd{middle * denominator, {}, {}}, roots);
  if (side != 0) return side < 0 ? low : high;
  const bool low_is_even = (std::bit_cast<std::uint64_t>(*low) & 1) == 0;
  return low_is_even ? low : high;
}

}  // namespace

std::optional<double> nearest_double(const Dyadic& numerator, const Dyadic& denominator) {
  if (numerator.sign() == 0) return 0.0;
  if (numerator.sign() < 0) return negated(nearest_double(-numerator, denominator));
  const Integer &above = numerator.mantissa(), &below = denominator.mantissa();
  const int shift = 66 - bits_of(above) + bits_of(below);
  Integer quotient, rest;
  if (shift >= 0)
    boost::multiprecision::divide_qr(Integer(above << shift), below, quotient, rest);
  else
    boost::multiprecision::divide_qr(above, Integer(below << -shift), quotient, rest);
  return round(quotient, rest.sign() == 0 ? Rest::none : Rest::some,
               numerator.exponent() - denominator.exponent() - shift);
}

std::optional<double> nearest_double(const Surd& numerator, const Radicands& roots,
                                     const Dyadic& denominator) {
  const int side = sign(numerator, roots);
  if (side == 0) return 0.0;
  return side > 0 ? nearest_to_positive(numerator, roots, denominator)
                  : negated(nearest_to_positive(-numerator, roots, denominator));
}

}  // namespace groundtruth::fast::exact_stage
