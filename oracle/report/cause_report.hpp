#pragma once
// Failures by their causes, as `groundtruth validate` shows them.

#include <string>

#include <groundtruth/report/validation_report.hpp>
#include <groundtruth/validation/causes.hpp>

namespace groundtruth::report {

// A paragraph a group: how many, the smallest of them and how it was before, what was answered and what is
// right, which inputs do not matter, and the command that asks the first of them again. Then the error that
// explains them.
std::string causes_of(const validation::Causes& causes, const ReplayCommand& replay_command);

}  // namespace groundtruth::report
