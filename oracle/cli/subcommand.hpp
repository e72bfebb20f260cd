#pragma once
// The subcommands of the program `groundtruth`. Each adds itself to the command line and says, once the line
// is parsed, how to run.

#include <functional>

#include <CLI/CLI.hpp>

namespace groundtruth::cli {

// What the program exits with.
enum class Exit {
  agrees = 0,
  disagrees = 1,
  usage = 2,
  unreadable = 3,
  broke_down = 4,
  nothing_judged = 5,
  interrupted = 130
};

struct Subcommand {
  CLI::App* command;
  std::function<Exit()> run;  // once the line is parsed, if it is this subcommand that was asked for
};

Subcommand add_answer(CLI::App& program);
Subcommand add_check(CLI::App& program);
Subcommand add_explain(CLI::App& program);
Subcommand add_judge(CLI::App& program);
Subcommand add_merge(CLI::App& program);
Subcommand add_report(CLI::App& program);
Subcommand add_scene(CLI::App& program);
Subcommand add_simulate(CLI::App& program);
Subcommand add_stability(CLI::App& program);
Subcommand add_validate(CLI::App& program);
Subcommand add_vectors(CLI::App& program);

}  // namespace groundtruth::cli
