#pragma once
// Lambda where a segment crosses a plane, in double-double, over any exact product. Not installed.
//
// As cell_kernels_body.hpp: nothing here may be shared between sets of instructions, hence the templates.

#include <groundtruth/fast/cell_kernels.hpp>
#include <groundtruth/fast/lanes.hpp>

namespace groundtruth::fast {

// What a product of doubles loses when it is rounded, by Dekker: exact unless a part under- or overflows.
// Ends: two numbers, those for a segment's two ends, abreast.
template <class Of>
struct DekkerProducts {
  using Ends = OneVector<Of>;

  template <class Number>
  static Number lost(Number a, Number b, Number product) {
    const Number a_scaled = splitter(a) * a, a_high = a_scaled - (a_scaled - a), a_low = a - a_high;
    const Number b_scaled = splitter(b) * b, b_high = b_scaled - (b_scaled - b), b_low = b - b_high;
    return a_low * b_low - (((product - a_high * b_high) - a_low * b_high) - a_high * b_low);
  }
  // a - quotient * b, of a quotient that is rounded to nearest.
  static double remainder(double a, double quotient, double b) {
    const double product = quotient * b;
    return (a - product) - lost(quotient, b, product);
  }

 private:
  static double splitter(double) { return 0x1p27 + 1; }
  static Ends splitter(Ends) { return Ends::all(0x1p27 + 1); }
};

template <class Products>
class DoubleDouble {
 public:
  using Ends = typename Products::Ends;

  // A sum of doubles, and what it lost.
  template <class Number>
  struct Sum {
    Number value;
    Number lost;
  };

  template <class Number>
  static Sum<Number> sum(Number a, Number b) {
    const Number rounded = a + b, b_part = rounded - a;
    return {rounded, (a - (rounded - b_part)) + (b - b_part)};
  }

  // value + rest is Delta but for 32 u^2 size + 2^-1060; |rest| <= 4 u size. size: the sum of the magnitudes
  // of its terms.
  struct Deltas {
    Ends value;
    Ends rest;
    Ends size;
  };

  static Deltas deltas(Ends n_x, Ends n_y, Ends n_z, Ends offset, Ends x, Ends y, Ends z) {
    const Ends p0 = n_x * x, p1 = n_y * y, p2 = n_z * z;
    const Ends e0 = Products::lost(n_x, x, p0), e1 = Products::lost(n_y, y, p1),
               e2 = Products::lost(n_z, z, p2);
    const auto s0 = sum(p0, p1), s1 = sum(p2, -offset), s2 = sum(s0.value, s1.value);
    return {s2.value, ((e0 + e1) + e2) + ((s0.lost + s1.lost) + s2.lost),
            magnitude(p0) + magnitude(p1) + magnitude(p2) + magnitude(offset)};
  }

 private:
  static Ends magnitude(Ends x) { return greater(x, -x); }
};

template <class Products>
RoundedCrossing rounded_crossing_of(double normal_x, double normal_y, double normal_z, double offset,
                                    const double* from, const double* to) {
  using Twice = DoubleDouble<Products>;
  using Ends = typename Products::Ends;
  constexpr double unit = 0x1p-53;
  const auto at =
      Twice::deltas(Ends::all(normal_x), Ends::all(normal_y), Ends::all(normal_z), Ends::all(offset),
                    Ends{{from[0], to[0]}}, Ends{{from[1], to[1]}}, Ends{{from[2], to[2]}});
  const auto difference = Twice::sum(at.value[0], -at.value[1]);
  const auto w = Twice::sum(difference.value, difference.lost + (at.rest[0] - at.rest[1]));

  const double q0 = at.value[0] / w.value;
  const double remainder = Products::remainder(at.value[0], q0, w.value) + (at.rest[0] - q0 * w.lost);
  // Beside q0, so that nothing waits for it.
  const double signed_inverse = 1 / w.value, inverse = __builtin_fabs(signed_inverse);
  const auto lambda = Twice::sum(q0, remainder * signed_inverse);

  const double size = at.size[0] + at.size[1], magnitude = __builtin_fabs(lambda.value);
  const double error = 128 * unit * unit * (size * inverse) * (1 + 2 * magnitude) +
                       32 * unit * unit * magnitude + 0x1p-1000 * (1 + 2 * magnitude) * inverse;
  const bool is_in_range = size < 0x1p900 && magnitude > 0x1p-900 && magnitude < 0x1p900;
  return {lambda.value,
          is_in_range && lambda.value + (lambda.lost + error) == lambda.value + (lambda.lost - error)};
}

}  // namespace groundtruth::fast
