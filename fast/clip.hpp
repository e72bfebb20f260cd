#pragma once
// Clipping a force to what a pebble can bear: as exactly as it can be told in doubles.

#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::fast {

// The part of the ask's force that lies in the border of the surface: SPEC section 4.
// 1. Too steep, stick or slip, and the case of a slip are those of exact numbers, for any doubles: decided in
//    doubles or double-double within a proven bound, else exactly (lemmas decisions-in-doubles,
//    counted-roundings and slip-signs, proofs-notes/rounding-of-forces.md).
// 2. Every component of the force is the exact one rounded to nearest, never -0: the same bits
//    everywhere (lemma clip-in-pairs). A force that sticks comes back bit for bit.
// 3. A component outside the range of doubles is refused ("force[0] leaves the range of doubles").
// No allocation but for the text of a refusal and where the exact stage needs more than 1,024 bits.
// Requires what the ask requires (finite numbers, friction >= 0, brake >= 0, min_uprightness > 0).
ClipAnswer clip(const ClipAsk& ask);

}  // namespace groundtruth::fast
