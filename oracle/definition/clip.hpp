#pragma once
// The second witness of force clipping (SPEC section 4).

#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::definition {

// Exact; the force is the correctly rounded one. A Refusal names a coordinate that no double can hold.
// Requires finite numbers, friction >= 0, brake >= 0, min_uprightness > 0.
ClipAnswer clip(const ClipAsk& ask);

}  // namespace groundtruth::definition
