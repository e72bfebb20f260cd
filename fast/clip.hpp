#pragma once
// Clipping a force to what a pebble can bear, in doubles.

#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::fast {

// The part of the ask's force that lies in the border of the surface: SPEC section 4.
// 1. Decisions (too steep, stick or slip, case of the slip) compare squares of rational expressions, without
//    a root or an angle. Where these can be computed without rounding (small integers, say) they are exact.
// 2. Otherwise they are those of plain doubles: unproved, and the force has no proved error bound.
// 3. A force that sticks comes back bit for bit.
// 4. A force outside the range of doubles is refused ("force[0] leaves the range of doubles"); no answer
//    bears a NaN or an infinity.
// No allocation but for the text of a refusal.
// Requires what the ask requires (finite numbers, friction >= 0, brake >= 0, min_uprightness > 0).
ClipAnswer clip(const ClipAsk& ask);

}  // namespace groundtruth::fast
