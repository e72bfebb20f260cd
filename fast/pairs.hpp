#pragma once
// Vectors of double-doubles, under one bound for a whole ask. Not installed.
//
// Each sum of products is off by at most 3 * 2^-102 of the sum of their magnitudes (lemmas pair-operations
// and loose-pairs, proofs-notes/rounding-of-forces.md, section 2).

#include <cmath>
#include <optional>

#include <groundtruth/fast/number_pair.hpp>
#include <groundtruth/problem/vector.hpp>

namespace groundtruth::fast {

// A vector whose components are doubles, or pairs.
template <class Pair>
using Doubles3 = typename Pair::Abreast::Number;
template <class Pair>
using Pairs3 = typename Pair::Abreast;

// To be summed on. A double has no low part. Pair: a pair, or three.
template <class Pair>
Pair product_of(const typename Pair::Number& a, const typename Pair::Number& b) {
  return Pair::product(a, b);
}
template <class Pair>
Pair product_of(const typename Pair::Number& a, const Pair& b) {
  return Pair::loose_product(a, b);
}
template <class Pair>
Pair product_of(const Pair& a, const typename Pair::Number& b) {
  return Pair::loose_product(b, a);
}
template <class Pair>
Pair product_of(const Pair& a, const Pair& b) {
  return Pair::loose_product(a, b);
}

template <class Pair>
Pair component(const Pairs3<Pair>& v, std::size_t axis) {
  return {v.high[axis], v.low[axis]};
}

template <class Pair, class A, class B>
Pair dot(const A& a, const B& b) {
  const auto products = product_of<Pairs3<Pair>>(a, b);
  const Pair first_two = Pair::loose_sum(component<Pair>(products, 0), component<Pair>(products, 1));
  return Pair::loose_sum(first_two, component<Pair>(products, 2)).tidy();
}

// a b - c d, loose: to be summed, multiplied or divided on, and made tidy then.
template <class Pair, class A, class B>
[[gnu::always_inline]] inline Pair determinant(const A& a, const B& b, const A& c, const B& d) {
  return Pair::loose_sum(product_of<Pair>(a, b), -product_of<Pair>(c, d));
}

// The components y, z and x.
template <class Registers>
Triple<Registers> next(const Triple<Registers>& v) {
  return v.next();
}
template <class Products, class Number>
PairWith<Products, Number> next(const PairWith<Products, Number>& v) {
  return {v.high.next(), v.low.next()};
}

// Loose as well.
template <class Pair, class A, class B>
Pairs3<Pair> cross(const A& a, const B& b) {
  return next(determinant<Pairs3<Pair>>(a, next(b), next(a), b));
}

// a / b by an approximate 1 / b that is within 2^-50 of it: within 2^-98 of its result (lemma quick-quotient,
// section 9).
template <class Pair>
Pair quotient(const Pair& a, const Pair& b, const typename Pair::Number& inverse) {
  const auto first = a.high * inverse;
  const Pair product = Pair::product(first, b.high);
  const auto rest = ((a.high - product.high) - product.low) + (a.low - first * b.low);
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
Pairs3<Pair> exact_differences(const Vector& a, const Vector& b) {
  return Pairs3<Pair>::sum(Doubles3<Pair>(a), -Doubles3<Pair>(b));
}

template <class Pair>
Vector highs_of(const Pair& v) {
  return Vector(v.high);
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

// The same of three, each within its error.
template <class Doubles>
struct NearestDoubles {
  static constexpr unsigned everywhere = 7;

  Doubles nearest;
  unsigned certain;  // a bit for each axis, the first the lowest
};
template <class Products, class Doubles>
NearestDoubles<Doubles> nearest_doubles(const PairWith<Products, Doubles>& v, const Doubles& error) {
  const Doubles more = error + magnitude(v.low) * 0x1p-50;
  const Doubles low = v.high + (v.low - more), high = v.high + (v.low + more);
  return {low, bits_where_same(low, high)};
}

// Zeros where numbers are uncertain; false unless they are zeros. `support` gives where the exact vector may
// differ from 0.
template <class GivesSupport>
bool put_zeros(unsigned certain, const GivesSupport& support, Vector& nearest) {
  for (std::size_t k = 0; k < 3; ++k) {
    if ((certain >> k & 1U) != 0) continue;
    if (support().has(k)) return false;
    nearest[k] = 0;
  }
  return true;
}
// Whether all three are certain.
template <class Pairs, class GivesSupport>
bool round_to_nearest(const Pairs& v, double error, const GivesSupport& support, Vector& nearest) {
  const auto rounded = nearest_doubles(v, typename Pairs::Number(error));
  nearest = Vector(rounded.nearest);
  return rounded.certain == rounded.everywhere || put_zeros(rounded.certain, support, nearest);
}

}  // namespace groundtruth::fast
