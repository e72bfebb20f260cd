#pragma once
// What `groundtruth validate` and `groundtruth merge` show.

#include <functional>
#include <string>
#include <vector>

#include <groundtruth/validation/record.hpp>

namespace groundtruth::report {

// A row a kind of ask, a column an outcome.
std::string table_of(const validation::Tally& tally);

// The failures, those that are known left out, in groups of a kind: the number of each, and of its simplest
// the ask, what was answered and what is right, and the command that asks it again.
using ReplayCommand = std::function<std::string(const std::string& id)>;
std::string failures_of(const std::vector<validation::Record>& records, const ReplayCommand& replay_command);

// The text, or the start of a long one and its length.
std::string in_brief(const std::string& text);

// As JUnit's XML: a suite a kind of ask; a test for each failure, and one for all asks that were accepted.
std::string junit_of(const validation::Tally& tally, const std::vector<validation::Record>& records);

}  // namespace groundtruth::report
