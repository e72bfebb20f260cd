#pragma once
// A step of the wheel, in doubles.

#include <groundtruth/fast/scene.hpp>
#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::fast {

// The wheel's state after the step and the force on its frame: SPEC section 5.
// 1. All decisions are those of plain doubles, those of entry_point.hpp and clip.hpp among them: exact where
//    nothing they need is rounded, else unproved; pebble, velocity and force have no proved error bound.
// 2. A pebble that sticks stays where it is, bit for bit, and so does its normal.
// 3. A contact with a surface that has no material, or no friction for the tyre, is refused with a reason
//    that names leaf and material, once contact would be made. A result outside the range of doubles is
//    refused with a reason that names it ("state.pebble[2] leaves the range of doubles"). No answer bears a
//    NaN or an infinity.
// 4. Safe for concurrent asks on one scene. No allocation but for a refusal's text and where entry_point
// does. Requires what the ask requires (finite numbers, signs and order of the wheel's parameters, an
// orientation that is not zero, brake >= 0, h > 0, friction >= 0).
StepAnswer step(const Scene& scene, const StepAsk& ask);

}  // namespace groundtruth::fast
