#pragma once
// Lambda where a segment crosses a plane, in double-double. Not installed.

#include <optional>

#include <groundtruth/problem/ask.hpp>
#include <groundtruth/problem/shape.hpp>

namespace groundtruth::fast {

// The correctly rounded lambda of the crossing, where this precision can tell: nothing if the bound (lemma
// crossing-in-double-double, proofs-notes/rounding.md) straddles a border between two doubles, or numbers
// are near the ends of their range. Requires that the segment's line crosses the plane.
std::optional<double> rounded_crossing(const HalfSpace& leaf, const EntryAsk& ask);

}  // namespace groundtruth::fast
