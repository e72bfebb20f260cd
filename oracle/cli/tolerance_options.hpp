#pragma once
// The options that say how much an answer may be off: shared by the subcommands that judge.

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include <groundtruth/judge/verdict.hpp>

namespace groundtruth::cli {

struct ToleranceOptions {
  std::string profile = "exact";
  std::optional<double> metres;
  std::optional<double> ulps;
  bool strict = false;
};

void add_tolerance_options(CLI::App& command, ToleranceOptions& options);

// The profile's tolerance, changed by the options that were given.
judge::Tolerance tolerance_of(const ToleranceOptions& options);

// One line: the profile and what it stands for, then the tolerances.
std::string in_words(const ToleranceOptions& options);

}  // namespace groundtruth::cli
