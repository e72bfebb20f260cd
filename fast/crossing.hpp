#pragma once
// Lambda where a segment crosses a plane, in double-double. Not installed.

#include <optional>

#include <groundtruth/fast/stage.hpp>
#include <groundtruth/problem/ask.hpp>
#include <groundtruth/problem/shape.hpp>

namespace groundtruth::fast {

// The correctly rounded lambda of the crossing, where this precision can tell: nothing if the bound (lemma
// crossing-in-double-double, proofs-notes/rounding.md) straddles a border between two doubles, or numbers
// are near the ends of their range. Requires that the segment's line crosses the plane.
std::optional<double> rounded_crossing(const HalfSpace& leaf, const EntryAsk& ask);

struct RoundedLambda {
  double value = 0;
  Stage stage = Stage::none;
};

// In double-double if that can tell, else exactly. Requires what the above does, and that the exact lambda
// lies between two doubles.
RoundedLambda correctly_rounded_crossing(const HalfSpace& leaf, const EntryAsk& ask);

}  // namespace groundtruth::fast
