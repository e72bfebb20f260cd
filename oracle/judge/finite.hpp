#pragma once
// What the text of an answer cannot say (SPEC section 8), an answer in this process can.

#include <groundtruth/problem/answer.hpp>

namespace groundtruth::judge {

bool has_only_finite_numbers(const Answer& answer);

}  // namespace groundtruth::judge
