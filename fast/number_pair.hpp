#pragma once
// Double-double arithmetic. Not installed.

#include <cmath>

namespace groundtruth::fast {

// The unevaluated sum of two doubles, high = fl(high + low). Each operation below is off by at most 2^-102 of
// its result, a sum of the sum of its terms' magnitudes (lemma pair-operations, proofs-notes/
// rounding-of-forces.md; Joldes, Muller, Popescu: Tight and rigorous error bounds for basic building blocks
// of double-word arithmetic, 2017), and by 2^-1060 where something underflows. Not finite where something
// overflows.
struct Pair {
  double high = 0;
  double low = 0;

  Pair() = default;
  Pair(double x) : high(x) {}  // implicit: nothing is lost
  Pair(double h, double l) : high(h), low(l) {}

  explicit operator double() const { return high; }
};

inline Pair two_sum(double a, double b) {
  const double sum = a + b, b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

// Requires |a| >= |b| or a = 0.
inline Pair fast_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

// Exact but for under- and overflow, with or without FMA: the same bits.
inline Pair two_product(double a, double b) {
  const double product = a * b;
#ifdef __FMA__
  return {product, __builtin_fma(a, b, -product)};
#else
  constexpr double splitter = 0x1p27 + 1;
  const double a_scaled = splitter * a, a_high = a_scaled - (a_scaled - a), a_low = a - a_high;
  const double b_scaled = splitter * b, b_high = b_scaled - (b_scaled - b), b_low = b - b_high;
  return {product, a_low * b_low - (((product - a_high * b_high) - a_low * b_high) - a_high * b_low)};
#endif
}

inline Pair operator+(const Pair& a, const Pair& b) {
  const Pair s = two_sum(a.high, b.high);
  return fast_two_sum(s.high, s.low + (a.low + b.low));
}
inline Pair operator-(const Pair& a) { return {-a.high, -a.low}; }
inline Pair operator-(const Pair& a, const Pair& b) { return a + -b; }
inline Pair operator*(const Pair& a, const Pair& b) {
  const Pair p = two_product(a.high, b.high);
  return fast_two_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}
inline Pair operator*(double a, const Pair& b) {
  const Pair p = two_product(a, b.high);
  return fast_two_sum(p.high, p.low + a * b.low);
}
inline Pair operator/(const Pair& a, const Pair& b) {
  const double first = a.high / b.high;
  const Pair rest = a - first * b;
  return fast_two_sum(first, rest.high / b.high);
}
inline Pair sqrt(const Pair& a) {
  if (a.high == 0) return {};
  const double first = std::sqrt(a.high);
  const Pair rest = a - two_product(first, first);
  return fast_two_sum(first, rest.high / (2 * first));
}

}  // namespace groundtruth::fast
