#pragma once
// Lambda where a segment crosses a plane, in double-double, over any exact product. Not installed.
//
// As cell_kernels_body.hpp: nothing here may be shared between sets of instructions, hence the templates.

#include <groundtruth/fast/cell_kernels.hpp>

namespace groundtruth::fast {

// An unevaluated sum: high = fl(high + low).
struct NumberPair {
  double high;
  double low;
};

// Dekker's: exact unless a part under- or overflows.
struct DekkerProducts {
  static NumberPair product(double a, double b) {
    constexpr double splitter = 0x1p27 + 1;
    const double a_scaled = splitter * a, a_high = a_scaled - (a_scaled - a), a_low = a - a_high;
    const double b_scaled = splitter * b, b_high = b_scaled - (b_scaled - b), b_low = b - b_high;
    const double rounded = a * b;
    return {rounded, a_low * b_low - (((rounded - a_high * b_high) - a_low * b_high) - a_high * b_low)};
  }
};

// Exact unless the error underflows or the product overflows: as good as Dekker's at least.
struct FusedProducts {
  static NumberPair product(double a, double b) {
    const double rounded = a * b;
    return {rounded, __builtin_fma(a, b, -rounded)};
  }
};

template <class Products>
class DoubleDouble {
 public:
  static NumberPair sum(double a, double b) {
    const double rounded = a + b, b_part = rounded - a;
    return {rounded, (a - (rounded - b_part)) + (b - b_part)};
  }

  // Requires |a| >= |b| or a = 0.
  static NumberPair ordered_sum(double a, double b) {
    const double rounded = a + b;
    return {rounded, b - (rounded - a)};
  }

  // Delta at x, and the sum of its terms' magnitudes.
  struct Delta {
    NumberPair value;
    double size;
  };

  // Off by at most 32 u^2 size + 2^-1060.
  static Delta delta(const double* normal, double offset, const double* x) {
    const NumberPair p0 = Products::product(normal[0], x[0]);
    const NumberPair p1 = Products::product(normal[1], x[1]);
    const NumberPair p2 = Products::product(normal[2], x[2]);
    const NumberPair s0 = sum(p0.high, p1.high);
    const NumberPair s1 = sum(p2.high, -offset);
    const NumberPair s2 = sum(s0.high, s1.high);
    const double rest = ((p0.low + p1.low) + p2.low) + ((s0.low + s1.low) + s2.low);
    return {sum(s2.high, rest), __builtin_fabs(p0.high) + __builtin_fabs(p1.high) + __builtin_fabs(p2.high) +
                                    __builtin_fabs(offset)};
  }
};

template <class Products>
RoundedCrossing rounded_crossing_of(const double* normal, double offset, const double* from,
                                    const double* to) {
  using Twice = DoubleDouble<Products>;
  constexpr double unit = 0x1p-53;
  const auto a = Twice::delta(normal, offset, from), b = Twice::delta(normal, offset, to);
  const NumberPair w_high = Twice::sum(a.value.high, -b.value.high);
  const NumberPair w = Twice::sum(w_high.high, w_high.low + (a.value.low - b.value.low));

  const double q0 = a.value.high / w.high;
  const NumberPair product = Products::product(q0, w.high);
  const double remainder = ((a.value.high - product.high) - product.low) + (a.value.low - q0 * w.low);
  // Beside q0, so that nothing waits for it.
  const double signed_inverse = 1 / w.high, inverse = __builtin_fabs(signed_inverse);
  const NumberPair lambda = Twice::ordered_sum(q0, remainder * signed_inverse);

  const double size = a.size + b.size, magnitude = __builtin_fabs(lambda.high);
  const double error = 128 * unit * unit * (size * inverse) * (1 + 2 * magnitude) +
                       32 * unit * unit * magnitude + 0x1p-1000 * (1 + 2 * magnitude) * inverse;
  const bool is_in_range = size < 0x1p900 && magnitude > 0x1p-900 && magnitude < 0x1p900;
  return {lambda.high,
          is_in_range && lambda.high + (lambda.low + error) == lambda.high + (lambda.low - error)};
}

}  // namespace groundtruth::fast
