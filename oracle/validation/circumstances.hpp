#pragma once
// What is notable about a case and its answer, so that a strand can tell whether it has been there before.

#include <cstdint>

#include <groundtruth/problem/scene.hpp>
#include <groundtruth/validation/finding.hpp>

namespace groundtruth::validation {

// Equal for cases that are alike: the kind of ask and of the exact answer; of an entry where in the range it
// lies, how many faces meet there, whether the range is usual and how far away it is; of a clip which border
// binds; of a step the states before and after; and how the answer got differs from the exact one.
std::uint64_t circumstances_of(const Ask& ask, const Finding& finding);

}  // namespace groundtruth::validation
