#pragma once
// The second witness of the wheel's step (SPEC section 5).

#include <groundtruth/definition/scene.hpp>
#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::definition {

// Exact; every double of the answer is the correctly rounded one. A Refusal names the leaf and the material
// of a contact without friction, or the quantity that no double can hold. Requires what SPEC section 5 says
// of a wheel, finite numbers, h > 0, brake >= 0, frictions >= 0, a quaternion other than 0. A state that
// touches the ground needs no scene until it slips: give one of `Nothing` for none.
StepAnswer step(const Scene& scene, const StepAsk& ask);

}  // namespace groundtruth::definition
