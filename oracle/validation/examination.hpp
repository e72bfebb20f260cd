#pragma once
// Asks a batch and judges it. Private to this folder.

#include <groundtruth/validation/run.hpp>

namespace groundtruth::validation {

// One finding an ask.
std::vector<Finding> examine(const Batch& batch, const Kinds& kinds, const judge::Tolerance& tolerance,
                             implementations::Subject& subject);

}  // namespace groundtruth::validation
