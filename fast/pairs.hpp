#pragma once
// Vectors of double-doubles, under one bound for a whole ask. Not installed.
//
// Each sum of products is off by at most 3 * 2^-102 of the sum of their magnitudes (lemmas pair-operations
// and loose-pairs, proofs-notes/rounding-of-forces.md, section 2).

#include <array>
#include <cmath>
#include <optional>

#include <groundtruth/fast/number_pair.hpp>
#include <groundtruth/problem/vector.hpp>

namespace groundtruth::fast {

template <class Real>
using Vector3 = std::array<Real, 3>;

// To be summed on. A double has no low part.
template <class Pair>
Pair product_of(double a, double b) {
  return Pair::product(a, b);
}
template <class Pair>
Pair product_of(double a, const Pair& b) {
  return Pair::loose_product(a, b);
}
template <class Pair>
Pair product_of(const Pair& a, double b) {
  return Pair::loose_product(b, a);
}
template <class Pair>
Pair product_of(const Pair& a, const Pair& b) {
  return Pair::loose_product(a, b);
}

template <class Pair, class A, class B>
Pair dot(const Vector3<A>& a, const Vector3<B>& b) {
  const Pair first_two = Pair::loose_sum(product_of<Pair>(a[0], b[0]), product_of<Pair>(a[1], b[1]));
  return Pair::loose_sum(first_two, product_of<Pair>(a[2], b[2])).tidy();
}

// a b - c d, loose: to be summed, multiplied or divided on, and made tidy then.
template <class Pair, class A, class B>
[[gnu::always_inline]] inline Pair determinant(const A& a, const B& b, const A& c, const B& d) {
  return Pair::loose_sum(product_of<Pair>(a, b), -product_of<Pair>(c, d));
}

// Loose as well.
template <class Pair, class A, class B>
Vector3<Pair> cross(const Vector3<A>& a, const Vector3<B>& b) {
  return {determinant<Pair>(a[1], b[2], a[2], b[1]), determinant<Pair>(a[2], b[0], a[0], b[2]),
          determinant<Pair>(a[0], b[1], a[1], b[0])};
}

// a / b by an approximate 1 / b that is within 2^-50 of it: within 2^-98 of its result (lemma quick-quotient,
// section 9).
template <class Pair>
Pair quotient(const Pair& a, const Pair& b, double inverse) {
  const double first = a.high * inverse;
  const Pair product = Pair::product(first, b.high);
  const double rest = ((a.high - product.high) - product.low) + (a.low - first * b.low);
  return Pair::sorted_sum(first, rest * inverse);
}

// A root, within 2^-99 of it, and a number within 2^-51 of its inverse. Requires a > 0.
template <class Pair>
struct Root {
  Pair value;
  double inverse;
};
template <class Pair>
Root<Pair> square_root(const Pair& a) {
  const double first = std::sqrt(a.high), inverse = 1 / first;
  const Pair square = Pair::product(first, first);
  const double rest = ((a.high - square.high) - square.low) + a.low;
  return {Pair::sorted_sum(first, rest * (0.5 * inverse)), inverse};
}

// Nothing is lost.
template <class Pair>
Vector3<Pair> exact_differences(const Vector& a, const Vector& b) {
  return {Pair::sum(a[0], -b[0]), Pair::sum(a[1], -b[1]), Pair::sum(a[2], -b[2])};
}

inline double high_of(double x) { return x; }
template <class Products>
double high_of(const PairWith<Products>& x) {
  return x.high;
}
template <class Real>
Vector highs_of(const Vector3<Real>& v) {
  return {high_of(v[0]), high_of(v[1]), high_of(v[2])};
}

inline double sum_of_magnitudes(const Vector& v) {
  return (std::abs(v[0]) + std::abs(v[1])) + std::abs(v[2]);
}
inline double dot_in_doubles(const Vector& a, const Vector& b) {
  return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
}
inline Vector cross_in_doubles(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// The double nearest to an exact number within `error` of x; nothing if that is uncertain, subnormal or not
// finite.
template <class Products>
std::optional<double> nearest_double(const PairWith<Products>& x, double error) {
  const double more = error + std::abs(x.low) * 0x1p-50;
  const double low = x.high + (x.low - more), high = x.high + (x.low + more);
  return low == high && std::abs(low) >= 0x1p-900 && std::isfinite(low) ? std::optional(low) : std::nullopt;
}
// Whether all three are certain. `support` gives where the exact vector may differ from 0.
template <class Pair, class GivesSupport>
bool round_to_nearest(const Vector3<Pair>& v, double error, const GivesSupport& support, Vector& nearest) {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto rounded = nearest_double(v[k], error);
    if (!rounded && support().has(k)) return false;
    nearest[k] = rounded ? *rounded : 0;
  }
  return true;
}

}  // namespace groundtruth::fast
