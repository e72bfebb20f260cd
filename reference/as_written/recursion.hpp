#pragma once
// Phi as the source writes it: by recursion over the expression, in plain doubles.

#include <optional>

#include <groundtruth/as_written/errata.hpp>
#include <groundtruth/as_written/expression.hpp>
#include <groundtruth/as_written/segment.hpp>

namespace groundtruth::as_written {

struct Reached {
  double lambda = 0;
  const Node* face = nullptr;  // of the half-space whose normal is the source's; null: the zero normal
};

// The first lambda of the range that lies in the expression, and the face by order of operands. Nothing: a
// miss; with Erratum::miss_is_plus_1000, a miss is a lambda that may exceed segment.last().
//
// With Erratum::normal_by_order a half-space is asked at the ends of whatever part of the range is left, as
// in the source; without it, always at the ends of the whole range (Segment::entry), for the faces' sake.
//
// The source's restarts may multiply with the nesting, and rounding may have two operands push each other on
// by ulps. So an intersection replaces its answer at most (nodes below it) + 2 times (exact numbers never
// need more than leaves + 2), and all of them together at most max(1,000,000, (nodes + 2)^2) times. What
// stands by then is the answer, which may be wrong: that is what bounds the time.
std::optional<Reached> first_reached(const Expression& expression, const Segment& segment,
                                     const Errata& errata);

}  // namespace groundtruth::as_written
