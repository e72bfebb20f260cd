#pragma once
// Many failures told by their causes: a smallest example of each, and the known error that explains them, if
// one does.

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include <groundtruth/diagnosis/diagnose.hpp>
#include <groundtruth/diagnosis/groups.hpp>
#include <groundtruth/validation/run.hpp>

namespace groundtruth::validation {

// A group of failures and its smallest representative, asked once more.
struct Cause {
  diagnosis::Group group;
  Failure smallest;
};

struct Causes {
  std::vector<Cause> groups;  // largest first
  // Of all that was answered wrongly, together.
  std::optional<diagnosis::Diagnosis> diagnosis;
};

struct SearchPlan {
  judge::Tolerance tolerance;
  std::chrono::milliseconds time{6000};  // for shrinking, in all; 0: nothing is shrunk
};

// Puts simpler cases to the implementation until none is found that fails in the same way. An ask that hung
// is not asked again. `accepted`: answers that were right, to acquit suspects by.
Causes causes_of(const std::vector<Failure>& failures, const std::vector<Failure>& accepted,
                 implementations::Subject& subject, const SearchPlan& plan);

}  // namespace groundtruth::validation
