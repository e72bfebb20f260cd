#pragma once
// Private to this folder.

#include <groundtruth/problem/answer.hpp>

namespace groundtruth::judge {

bool has_only_finite_numbers(const Answer& answer);

}  // namespace groundtruth::judge
