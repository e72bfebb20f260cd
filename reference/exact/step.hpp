#pragma once
// One step of the pebble-and-spring wheel, exactly (SPEC section 5).

#include <groundtruth/exact/finding.hpp>
#include <groundtruth/exact/scene.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::exact {

// Guarantees, for every valid ask:
// 1. outcome, state and contact are those of the exact step from these doubles; a slip's new pebble is
//    u + v sqrt(A) + w sqrt(D), and Phi there is decided on such numbers (proofs-notes/wheel.md, sections 1,
//    2);
// 2. every double of the answer is the exact value rounded to nearest; a sticking pebble, its normal and its
//    friction come back bit for bit.
// Refuses a contact without material or without friction for the tyre, naming leaf and material, and a result
// outside the range of doubles, naming the quantity. World frame, SI.
Finding<StepAnswer> step(const Scene& scene, const StepAsk& ask, Digits digits = Digits::none);

}  // namespace groundtruth::exact
