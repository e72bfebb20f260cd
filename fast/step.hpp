#pragma once
// A step of the wheel: as exactly as it can be told in doubles.

#include <groundtruth/fast/scene.hpp>
#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::fast {

// The wheel's state after the step and the force on its frame: SPEC section 5.
// 1. Outcome, state, contact and every decision on the way are those of exact numbers, for any doubles:
//    decided in doubles or double-double within a proven bound, else exactly (lemmas decisions-in-doubles and
//    counted-roundings, proofs-notes/rounding-of-forces.md).
// 2. Every component of pebble, velocity and force is the exact one rounded to nearest, never -0: the
//    same bits everywhere (lemmas load-in-pairs, clip-in-pairs and strut-in-pairs). A pebble that sticks
//    stays where it is, bit for bit, and so does its normal.
// 3. A contact with a surface that has no material, or no friction for the tyre, is refused with a reason
//    that names leaf and material, once contact would be made. A result outside the range of doubles is
//    refused with a reason that names it ("state.pebble[2] leaves the range of doubles").
// 4. Safe for concurrent asks on one scene. No allocation but for a refusal's text, where entry_point does,
// and
//    where the exact stage needs more than 1,024 bits.
// Requires what the ask requires (finite numbers, signs and order of the wheel's parameters, an orientation
// that is not zero, brake >= 0, h > 0, friction >= 0).
StepAnswer step(const Scene& scene, const StepAsk& ask);

}  // namespace groundtruth::fast
