#pragma once
// Half-spaces along a segment, in exact numbers of several kinds, and comparing where they are crossed
// without a division. Not installed.

#include <boost/container/small_vector.hpp>
#include <groundtruth/fast/exact_stage/fixed.hpp>
#include <groundtruth/fast/exact_stage/surd.hpp>

namespace groundtruth::fast::exact_stage {

// The kinds of numbers. Values are only added and compared, and multiplied by slopes: `sign_of_difference` is
// the sign of a b - c d for values a, c and slopes b, d.
template <std::size_t words>
struct FixedNumbers {
  using Value = Fixed<words>;
  using Slope = Fixed<words>;
  static Value value(const Slope& x) { return x; }
  static int sign(const Value& x) { return x.sign(); }
  static int sign_of_difference(const Value& a, const Slope& b, const Value& c, const Slope& d) {
    return (full_product(a, b) - full_product(c, d)).sign();
  }
};

struct DyadicNumbers {
  using Value = Dyadic;
  using Slope = Dyadic;
  static Value value(const Slope& x) { return x; }
  static int sign(const Value& x) { return x.sign(); }
  static int sign_of_difference(const Value& a, const Slope& b, const Value& c, const Slope& d) {
    return (a * b - c * d).sign();
  }
};

struct SurdNumbers {
  using Value = Surd;
  using Slope = Dyadic;
  static Value value(const Slope& x) { return {x, {}, {}}; }
  Radicands roots;
  int sign(const Value& x) const { return exact_stage::sign(x, roots); }
  int sign_of_difference(const Value& a, const Slope& b, const Value& c, const Slope& d) const {
    return sign(a * b - c * d);
  }
};

// Delta along the segment, times a positive number: value + t slope, where t is 0 at the start of the range.
template <class Numbers>
struct Line {
  typename Numbers::Value value{};
  typename Numbers::Slope slope{};
  int slope_sign = 0;

  bool enters() const { return slope_sign < 0; }
  bool leaves() const { return slope_sign > 0; }
};

// So many of them fit without allocation.
template <class Numbers>
using Lines = boost::container::small_vector<Line<Numbers>, 16384 / sizeof(Line<Numbers>)>;

// A place on the segment is where some line is zero: t = -value / slope. Requires slope != 0.
template <class Numbers>
using Place = const Line<Numbers>*;

// The sign of t_a - t_b, by the determinant of the two lines.
template <class Numbers>
int compare(const Numbers& numbers, Place<Numbers> a, Place<Numbers> b) {
  if (a == b) return 0;
  return numbers.sign_of_difference(b->value, a->slope, a->value, b->slope) * a->slope_sign * b->slope_sign;
}

// The sign of the line at a place.
template <class Numbers>
int side(const Numbers& numbers, const Line<Numbers>& line, Place<Numbers> place) {
  if (&line == place) return 0;
  return numbers.sign_of_difference(line.value, place->slope, place->value, line.slope) * place->slope_sign;
}

}  // namespace groundtruth::fast::exact_stage
