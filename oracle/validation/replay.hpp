#pragma once
// The cases that a name or a file stands for.

#include <string>
#include <vector>

#include <groundtruth/cases/case.hpp>

namespace groundtruth::validation {

// `what` is the id of a generated case (case_name.hpp) or of one of the corpus, a file of records
// (record.hpp; lines that are none of a case are passed over), or a file of asks (SPEC section 8). Throws
// BadInput if it is none of these.
std::vector<cases::Case> cases_to_replay(const std::string& what);

}  // namespace groundtruth::validation
