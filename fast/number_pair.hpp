#pragma once
// Double-double arithmetic. Not installed.

#include <cmath>
#include <concepts>

#include <groundtruth/fast/triple.hpp>

namespace groundtruth::fast {

// What a product of doubles loses when it is rounded: exact but for under- and overflow. Both ways give the
// same bits; `fused` is quick where the compiler may use FMA instructions, and right anywhere.
struct SplitProducts {
  using Abreast = Triple<HalfRegisters>;

  template <class Number>
  static Number lost(const Number& a, const Number& b, const Number& product) {
    constexpr double splitter = 0x1p27 + 1;
    const Number a_scaled = splitter * a, a_high = a_scaled - (a_scaled - a), a_low = a - a_high;
    const Number b_scaled = splitter * b, b_high = b_scaled - (b_scaled - b), b_low = b - b_high;
    return a_low * b_low - (((product - a_high * b_high) - a_low * b_high) - a_high * b_low);
  }
};
struct FusedProducts {
  using Abreast = Triple<WholeRegister>;

  static double lost(double a, double b, double product) { return __builtin_fma(a, b, -product); }
  static Abreast lost(const Abreast& a, const Abreast& b, const Abreast& product) {
    return multiply_and_subtract(a, b, product);
  }
};

// The unevaluated sum of two doubles, high = fl(high + low). Each operation below is off by at most 2^-102 of
// its result, a sum of the sum of its terms' magnitudes (lemma pair-operations, proofs-notes/
// rounding-of-forces.md; Joldes, Muller, Popescu: Tight and rigorous error bounds for basic building blocks
// of double-word arithmetic, 2017), and by 2^-1060 where something underflows. Not finite where something
// overflows. Number: a double, or three abreast.
template <class Products, class Component = double>
struct PairWith {
  using Number = Component;
  using Abreast = PairWith<Products, typename Products::Abreast>;

  Number high{};
  Number low{};

  PairWith() = default;
  PairWith(const Number& x) : high(x) {}  // implicit: nothing is lost
  PairWith(const Number& h, const Number& l) : high(h), low(l) {}
  template <std::convertible_to<Number> Other>
  PairWith(const PairWith<Products, Other>& x)  // implicit: the same in every lane
      : high(x.high), low(x.low) {}

  static PairWith sum(const Number& a, const Number& b) {
    const Number sum = a + b, b_part = sum - a;
    return {sum, (a - (sum - b_part)) + (b - b_part)};
  }
  // Requires |a| >= |b| or a = 0.
  static PairWith sorted_sum(const Number& a, const Number& b) {
    const Number sum = a + b;
    return {sum, b - (sum - a)};
  }
  static PairWith product(const Number& a, const Number& b) {
    const Number product = a * b;
    return {product, Products::lost(a, b, product)};
  }

  explicit operator double() const { return high; }

  // Sums and products whose low part may be some last places of high long: lemma loose-pairs. To be summed
  // on, and made tidy once.
  static PairWith loose_sum(const PairWith& a, const PairWith& b) {
    const PairWith s = sum(a.high, b.high);
    return {s.high, s.low + (a.low + b.low)};
  }
  static PairWith loose_product(const PairWith& a, const PairWith& b) {
    const PairWith p = product(a.high, b.high);
    return {p.high, p.low + (a.high * b.low + a.low * b.high)};
  }
  static PairWith loose_product(const Number& a, const PairWith& b) {
    const PairWith p = product(a, b.high);
    return {p.high, p.low + a * b.low};
  }
  PairWith tidy() const { return sorted_sum(high, low); }

  friend PairWith operator+(const PairWith& a, const PairWith& b) { return loose_sum(a, b).tidy(); }
  friend PairWith operator-(const PairWith& a) { return {-a.high, -a.low}; }
  friend PairWith operator-(const PairWith& a, const PairWith& b) { return a + -b; }
  friend PairWith operator*(const PairWith& a, const PairWith& b) { return loose_product(a, b).tidy(); }
  friend PairWith operator*(const Number& a, const PairWith& b) { return loose_product(a, b).tidy(); }
  friend PairWith operator/(const PairWith& a, const PairWith& b) {
    const double first = a.high / b.high;
    const PairWith rest = a - first * b;
    return sorted_sum(first, rest.high / b.high);
  }
  friend PairWith sqrt(const PairWith& a) {
    if (a.high == 0) return {};
    const double first = std::sqrt(a.high);
    const PairWith rest = a - product(first, first);
    return sorted_sum(first, rest.high / (2 * first));
  }
};

using Pair = PairWith<SplitProducts>;
using FusedPair = PairWith<FusedProducts>;

}  // namespace groundtruth::fast
