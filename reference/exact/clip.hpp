#pragma once
// The force that a pebble can bear, exactly (SPEC section 4).

#include <groundtruth/exact/finding.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::exact {

// Guarantees, for every valid ask:
// 1. too steep, stick or slip, and which case of slip: as for exact numbers; all decisions compare squares,
// which
//    are rational (lemma decisions-by-squares, proofs-notes/clipping.md, section 2);
// 2. each component of the force is the exact one, a sum of at most two square roots, rounded to nearest.
// A component that leaves the range of doubles comes back as a Refusal that names it. Wheel frame, newtons.
Finding<ClipAnswer> clip(const ClipAsk& ask, Digits digits = Digits::none);

}  // namespace groundtruth::exact
