#pragma once
// The command line of `groundtruth validate`.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include <groundtruth/implementations/subject.hpp>
#include <groundtruth/validation/causes.hpp>
#include <groundtruth/validation/course.hpp>

#include "tolerance_options.hpp"

namespace groundtruth::cli {

struct ValidateOptions {
  std::vector<std::string> command;
  std::string engine;
  std::string library;
  ToleranceOptions tolerance;
  std::optional<std::uint64_t> cases;
  std::optional<double> seconds;
  std::uint64_t seed = 1;
  unsigned jobs = 1;
  double patience = 10;  // seconds an ask
  std::string shard = "1/1";
  std::vector<std::string> only;
  std::uint64_t most_failures = 200;
  double shrinking = 6;  // seconds in all
  std::string known;
  bool update_known = false;
  std::string json;
  std::string junit;
  std::string html;
  std::string replay;
};

void add_options(CLI::App& command, ValidateOptions& options);

// The first problem that the command line has beyond what CLI11 finds, in one line.
std::optional<std::string> problem_with(const ValidateOptions& options);

// Requires that there is no problem. The kinds that `greeting` claims and --only asks for.
validation::Kinds kinds_of(const ValidateOptions& options, const implementations::Greeting& greeting);
validation::Selection selection_of(const ValidateOptions& options, const validation::Kinds& kinds);
validation::RunPlan run_plan_of(const ValidateOptions& options, const validation::Kinds& kinds);
validation::SearchPlan search_plan_of(const ValidateOptions& options);

// Throws with a line that says why there is none.
std::unique_ptr<implementations::Subject> subject_of(const ValidateOptions& options);

// The command that asks this case again, for a shell.
std::string replay_command_of(const ValidateOptions& options, const std::string& id);

}  // namespace groundtruth::cli
