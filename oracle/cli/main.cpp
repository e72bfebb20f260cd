#include <cstdio>
#include <exception>

#include "subcommand.hpp"

namespace {

using groundtruth::cli::Exit;
using groundtruth::cli::Subcommand;

int run(int argc, char** argv) {
  CLI::App program("Ground contact, exactly: entry points, friction and the wheel's step.", "groundtruth");
  program.require_subcommand(1);
  program.set_help_all_flag("--help-all", "Help for every subcommand");
  program.failure_message(CLI::FailureMessage::help);
  const Subcommand subcommands[] = {
      groundtruth::cli::add_answer(program),
      groundtruth::cli::add_check(program),
      groundtruth::cli::add_explain(program),
      groundtruth::cli::add_judge(program),
      groundtruth::cli::add_merge(program),
      groundtruth::cli::add_report(program),
      groundtruth::cli::add_scene(program),
      groundtruth::cli::add_simulate(program),
      groundtruth::cli::add_stability(program),
      groundtruth::cli::add_validate(program),
      groundtruth::cli::add_vectors(program),
  };
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const bool asked_for_help = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success);
    program.exit(error);
    return static_cast<int>(asked_for_help ? Exit::agrees : Exit::usage);
  }
  for (const auto& [command, run_it] : subcommands) {
    if (command->parsed()) return static_cast<int>(run_it());
  }
  return static_cast<int>(Exit::usage);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "groundtruth: %s\n", error.what());
    return static_cast<int>(Exit::unreadable);
  }
}
