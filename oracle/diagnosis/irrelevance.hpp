#pragma once
// Which inputs of a failing case do not matter.

#include <string>
#include <vector>

#include <groundtruth/diagnosis/shrink.hpp>

namespace groundtruth::diagnosis {

// Names of inputs (inputs.hpp; a vector whose coordinates all do not matter by its own name) that may be
// changed, one at a time, to any of several other values, and the case still fails in the same way.
std::vector<std::string> inputs_that_do_not_matter(const cases::Case& failing, const StillFail& still_fail);

}  // namespace groundtruth::diagnosis
