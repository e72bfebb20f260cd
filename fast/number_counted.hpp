#pragma once
// Numbers that know how far rounding may have moved them. Not installed.

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <groundtruth/fast/number_pair.hpp>

namespace groundtruth::fast {

// Each operation of pairs is off by at most this part of its result, or of the sum of its terms' magnitudes.
inline constexpr double pair_unit = 0x1p-102;

// Guarantees (lemma counted-roundings, proofs-notes/rounding-of-forces.md, section 1):
// 1. |exact| <= size and |value - exact| <= error(), where size and error() are not finite if that is not so.
// 2. size = 0: the exact number is 0, and so is value.
// The roundings are counted by the compiler; sizes are computed in doubles, at one operation each.
template <class Real, int n>
struct Counted {
  static constexpr int roundings = n;

  Real value{};
  double size = 0;

  // One unit each; 2^-10 of that for second-order terms, underflow, and the rounding of sizes.
  static constexpr double units = n * pair_unit * (1 + 0x1p-10);
  double error() const { return units * size; }

  // With less roundings, any number is one with more.
  template <int more>
  operator Counted<Real, more>() const {
    static_assert(more >= n);
    return {value, size};
  }
};

// What is not zero counts as at least this: so no size underflows, and underflow of a value is less than its
// last unit of error.
inline constexpr double least_size = 0x1p-900;

inline double product_of_sizes(double a, double b) {
  const double product = a * b;
  if (!(product < least_size)) return product;  // or not a number
  return a == 0 || b == 0 ? 0 : least_size;
}

template <class Real>
Counted<Real, 0> counted(double x) {
  return {Real(x), x == 0 ? 0 : std::max(std::abs(x), least_size)};
}

// The difference is a number of its own, rounded once: where it is 0, so is its size.
template <class Real>
Counted<Real, 1> difference(double a, double b) {
  const Real value = Real::sum(a, -b);
  const double size = std::abs(static_cast<double>(value));
  return {value, size == 0 ? 0 : std::max(size * (1 + 0x1p-50), least_size)};
}

template <class Real, int m, int n>
Counted<Real, std::max(m, n) + 1> operator+(const Counted<Real, m>& a, const Counted<Real, n>& b) {
  return {a.value + b.value, a.size + b.size};
}
template <class Real, int m, int n>
Counted<Real, std::max(m, n) + 1> operator-(const Counted<Real, m>& a, const Counted<Real, n>& b) {
  return {a.value - b.value, a.size + b.size};
}
template <class Real, int n>
Counted<Real, n> operator-(const Counted<Real, n>& a) {
  return {-a.value, a.size};
}
// A product to be summed on: an input has no low part.
template <class Real, int m, int n>
Real loose_product(const Counted<Real, m>& a, const Counted<Real, n>& b) {
  if constexpr (m == 0 && n == 0)
    return Real::product(a.value.high, b.value.high);
  else if constexpr (m == 0)
    return Real::loose_product(a.value.high, b.value);
  else if constexpr (n == 0)
    return Real::loose_product(b.value.high, a.value);
  else
    return Real::loose_product(a.value, b.value);
}
template <class Real, int m, int n>
Counted<Real, m + n + 1> operator*(const Counted<Real, m>& a, const Counted<Real, n>& b) {
  return {loose_product(a, b).tidy(), product_of_sizes(a.size, b.size)};
}
// Lemma counted-square: one of the two factors of its size may be as small as the number itself, so that a
// square near 0 is known as precisely as its root.
template <class Real, int n>
Counted<Real, 2 * n + 1> square(const Counted<Real, n>& a) {
  const double near = std::abs(static_cast<double>(a.value)) * (1 + 0x1p-50) + 2 * a.error();
  return {a.value * a.value, a.size == 0 ? 0 : std::max(a.size * near, least_size)};
}
template <class Real, int n>
Counted<Real, n> twice(const Counted<Real, n>& a) {
  return {a.value + a.value, 2 * a.size};
}
template <class Real, int n>
Counted<Real, n> magnitude(const Counted<Real, n>& a) {
  return static_cast<double>(a.value) < 0 ? -a : a;
}

// Lemma counted-quotient: requires nothing; size is not finite unless b is known to 10 bits.
template <class Real, int m, int n>
Counted<Real, m + n + 2> operator/(const Counted<Real, m>& a, const Counted<Real, n>& b) {
  const double divisor = std::abs(static_cast<double>(b.value));
  if (!(divisor > 0 && b.error() <= 0x1p-10 * divisor))
    return {Real(0.0), std::numeric_limits<double>::infinity()};
  const double inverse = 1.01 / divisor;
  if (a.size == 0) return {};
  return {a.value / b.value, std::max((a.size * inverse) * std::max(b.size * inverse, 1.0), least_size)};
}

// Lemma counted-root. Requires that the exact a is not negative.
template <class Real, int n>
Counted<Real, (n + 1) / 2 + 1> root(const Counted<Real, n>& a) {
  if (a.size == 0) return {};
  const auto approximate = static_cast<double>(a.value);
  if (!(a.error() <= 0x1p-10 * approximate)) return {Real(0.0), std::numeric_limits<double>::infinity()};
  return {sqrt(a.value), 1.01 * std::max(a.size, approximate) / std::sqrt(approximate)};
}

enum class Sign { negative = -1, zero = 0, positive = 1, uncertain = 2 };

// Certainly right, or uncertain.
template <class Real, int n>
Sign sign_of(const Counted<Real, n>& a) {
  if (a.size == 0) return Sign::zero;
  const auto approximate = static_cast<double>(a.value);
  // Twice the error covers that this is rounded once more.
  if (std::abs(approximate) > 2 * a.error()) return approximate > 0 ? Sign::positive : Sign::negative;
  return Sign::uncertain;
}

// The double nearest to the exact number; nothing if that is uncertain or not finite.
template <class Products, int n>
std::optional<double> nearest_double(const Counted<PairWith<Products>, n>& a) {
  if (a.size == 0) return 0.0;
  const double error = a.error() + std::abs(a.value.low) * 0x1p-50;
  const double low = a.value.high + (a.value.low - error), high = a.value.high + (a.value.low + error);
  // Subnormal results are left to others: there the parts of a pair may have been rounded.
  return low == high && std::abs(low) >= 0x1p-900 && std::isfinite(low) ? std::optional(low) : std::nullopt;
}

}  // namespace groundtruth::fast
