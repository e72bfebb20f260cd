#include <groundtruth/exact/solid/sieve.hpp>

#include <CGAL/Interval_nt.h>

namespace groundtruth::exact {
namespace {

using Interval = CGAL::Interval_nt<false>;  // the caller protects the rounding mode
using IntervalPoint = std::array<Interval, 3>;

IntervalPoint to_intervals(const PointEnclosure& point) {
  return {Interval(point[0]), Interval(point[1]), Interval(point[2])};
}

Interval delta(const HalfSpace& half_space, const IntervalPoint& x) {
  const auto& [n, d] = half_space;
  return Interval(n[0]) * x[0] + Interval(n[1]) * x[1] + Interval(n[2]) * x[2] - Interval(d);
}

// NaN, from infinity times zero, is neither.
bool certainly_negative(const Interval& value) { return value.sup() < 0; }
bool certainly_positive(const Interval& value) { return value.inf() > 0; }

}  // namespace

Expression sieve(const Solid& solid, const PointEnclosure& first, const PointEnclosure& last) {
  const CGAL::Protect_FPU_rounding<true> upwards;
  const IntervalPoint first_point = to_intervals(first);
  const IntervalPoint last_point = to_intervals(last);
  return reduced(solid.expression, [&](Leaf leaf) {
    const HalfSpace& half_space = solid.half_spaces[leaf];
    const Interval at_first = delta(half_space, first_point);
    const Interval at_last = delta(half_space, last_point);
    if (certainly_negative(at_first) && certainly_negative(at_last)) return Truth::yes;
    if (certainly_positive(at_first) && certainly_positive(at_last)) return Truth::no;
    return Truth::unknown;
  });
}

}  // namespace groundtruth::exact
