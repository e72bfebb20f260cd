#include <csignal>

#include <atomic>
#include <memory>
#include <optional>

#include <fmt/core.h>

#include <groundtruth/cases/corpus.hpp>
#include <groundtruth/validation/run.hpp>
#include <groundtruth/validation/strand.hpp>

#include "progress_bar.hpp"
#include "subcommand.hpp"

namespace groundtruth::cli {
namespace {

using namespace validation;

struct Options {
  std::vector<std::string> command;
  std::string engine;
  std::uint64_t seed = 1;
  std::uint64_t cases = 20000;
  unsigned jobs = 1;
  std::string profile = "exact";
};

std::unique_ptr<implementations::Subject> subject_of(const Options& options) {
  auto subject = options.engine.empty() ? implementations::run_command(options.command, {})
                                        : implementations::engine_subject(options.engine);
  if (auto* none = std::get_if<implementations::NoSubject>(&subject)) throw std::runtime_error(none->problem);
  return std::move(std::get<0>(subject));
}

Exit run(const Options& options) {
  RunPlan plan;
  for (const auto& p : judge::profiles())
    if (p.name == options.profile) plan.tolerance = p.tolerance;
  plan.jobs = options.jobs;
  const std::uint64_t strands = (options.cases + 999) / 1000;
  const StreamAt stream_at = [&](std::size_t i) -> std::unique_ptr<Stream> {
    if (i == 0) return stream_of(cases::corpus());
    if (i > strands) return nullptr;
    return strand_of({options.seed, i - 1, 1000, {}});
  };
  Watch watch;
  watch.failed = [](const Failure& failure) {
    fmt::print("{} {} {}\n", failure.asked.id, name_of(failure.finding.outcome),
               explanation_of(failure.finding));
  };
  const Result result = validation::run(
      plan, stream_at, [&] { return subject_of(options); }, watch);
  for (Kind kind : {Kind::entry, Kind::clip, Kind::step})
    fmt::print("{} judged {} wrong {} crashed {} hung {} unreadable {} skipped {}\n", name_of(kind),
               result.tally.judged(kind), result.tally.count(kind, Outcome::wrong),
               result.tally.count(kind, Outcome::crashed), result.tally.count(kind, Outcome::hung),
               result.tally.count(kind, Outcome::unreadable), result.tally.count(kind, Outcome::skipped));
  fmt::print("{} s\n", result.seconds);
  return result.failures.empty() ? Exit::agrees : Exit::disagrees;
}

}  // namespace

Subcommand add_validate(CLI::App& program) {
  CLI::App* command = program.add_subcommand("validate", "Judges an implementation");
  const auto options = std::make_shared<Options>();
  command->add_option("command", options->command, "The implementation");
  command->add_option("--engine", options->engine, "One of our own");
  command->add_option("--seed", options->seed, "Of the cases");
  command->add_option("--cases", options->cases, "How many");
  command->add_option("--jobs", options->jobs, "Threads");
  command->add_option("--profile", options->profile, "Tolerances");
  return {command, [options] { return run(*options); }};
}

}  // namespace groundtruth::cli
