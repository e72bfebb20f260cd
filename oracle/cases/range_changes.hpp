#pragma once
// The same stretch of a line under other parameters.

#include <groundtruth/cases/random.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::cases {

// The ends move along the line and the range with them, so that the stretch that is asked about stays,
// exactly where numbers are short; the range is then seldom [0, 1], and may lie below 0 or beyond 1. The
// result is the ask itself where it would not be finite.
EntryAsk with_range_moved(const EntryAsk& ask, Random& random);

}  // namespace groundtruth::cases
