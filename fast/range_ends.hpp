#pragma once
// The two ends of an ask's range as points in doubles, with what rounding did to them. Not installed.

#include <algorithm>
#include <cmath>

#include <groundtruth/problem/ask.hpp>

namespace groundtruth::fast {

// Exact: the point the ask means. |first[k] - exact| and |last[k] - exact| are at most coordinate_error.
// Whoever has ends of his own (a wheel's strut, with roots in them) may search with them as well.
struct RangeEnds {
  Vector first{};
  Vector last{};
  double coordinate_error = 0;

  // Of both ends.
  double greatest_coordinate() const {
    double greatest = 0;
    for (const Vector* end : {&first, &last})
      for (const double x : *end) greatest = std::max(greatest, std::abs(x));
    return greatest;
  }
};

// Lemma range-ends (proofs-notes/rounding.md): from + lambda (to - from), rounded at each of three
// operations, is off by at most u (1 + u)^2 (3 |lambda| (|from| + |to|) + |from|); 4 u covers that and the
// rounding of the bound itself, 2^-1000 whatever underflows. Infinite or NaN: nothing is known.
inline RangeEnds ends_of(const EntryAsk& ask) {
  if (ask.lambda_first == 0 && ask.lambda_last == 1) return {ask.from, ask.to, 0};
  RangeEnds ends;
  const auto place = [&](double lambda, std::size_t axis) {
    const double from = ask.from[axis], to = ask.to[axis];
    if (lambda == 0) return from;
    if (lambda == 1) return to;
    const double reach = std::abs(from) + std::abs(to);
    ends.coordinate_error =
        std::max(ends.coordinate_error, 0x4p-53 * (std::abs(lambda) * reach + std::abs(from)) + 0x1p-1000);
    return from + lambda * (to - from);
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    ends.first[axis] = place(ask.lambda_first, axis);
    ends.last[axis] = place(ask.lambda_last, axis);
  }
  return ends;
}

}  // namespace groundtruth::fast
