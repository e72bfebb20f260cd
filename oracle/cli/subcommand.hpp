#pragma once
// The subcommands of the program `groundtruth`. Each adds itself to the command line and says, once the line
// is parsed, how to run.

#include <functional>

#include <CLI/CLI.hpp>

namespace groundtruth::cli {

// What the program exits with.
enum class Exit { agrees = 0, disagrees = 1, usage = 2, unreadable = 3 };

// Called if the subcommand is the one that was asked for.
using Run = std::function<Exit()>;

Run add_answer(CLI::App& program);
Run add_check(CLI::App& program);

}  // namespace groundtruth::cli
