#pragma once
// The two ends of an ask's range as points in doubles, with what rounding did to them.

#include <algorithm>
#include <cmath>
#include <cstddef>

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
    const auto greater = [&](std::size_t axis) {
      return std::max(std::abs(first[axis]), std::abs(last[axis]));
    };
    return std::max(greater(0), std::max(greater(1), greater(2)));
  }
};

// Lemma range-ends (proofs-notes/rounding.md): from + lambda (to - from), rounded at each of three
// operations, is off by at most u (1 + u)^2 (3 |lambda| (|from| + |to|) + |from|); 4 u covers that and the
// rounding of the bound itself, 2^-1000 whatever underflows. Infinite or NaN: nothing is known.
inline RangeEnds ends_within(const EntryAsk& ask) {
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

inline RangeEnds ends_of(const EntryAsk& ask) {
  const bool is_whole = ask.lambda_first == 0 && ask.lambda_last == 1;
  return is_whole ? RangeEnds{ask.from, ask.to, 0} : ends_within(ask);
}

}  // namespace groundtruth::fast
