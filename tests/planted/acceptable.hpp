#pragma once
// Whether an answer could be right. It errs on the side of the answer: the oracle's own judge must find fault
// with whatever is not acceptable here.

#include <groundtruth/implementations/engine.hpp>

#include "right.hpp"

namespace groundtruth::planted {

// `exact` is the exact engine's answer to `ask` about the scene of `right`.
bool is_acceptable(const Answer& got, const implementations::Answered& exact, const Ask& ask,
                   const Right& right);

}  // namespace groundtruth::planted
