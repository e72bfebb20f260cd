#include "validate_options.hpp"

#include <charconv>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "for_shell.hpp"

namespace groundtruth::cli {
namespace {

using namespace validation;

std::optional<Shard> shard_in(const std::string& text) {
  Shard shard{0, 0};
  const char* end = text.data() + text.size();
  const auto index = std::from_chars(text.data(), end, shard.index);
  if (index.ec != std::errc{} || index.ptr == end || *index.ptr != '/') return std::nullopt;
  const auto count = std::from_chars(index.ptr + 1, end, shard.count);
  if (count.ec != std::errc{} || count.ptr != end) return std::nullopt;
  if (shard.index < 1 || shard.index > shard.count) return std::nullopt;
  return shard;
}

std::chrono::milliseconds milliseconds(double seconds) {
  return std::chrono::milliseconds(static_cast<std::int64_t>(std::ceil(seconds * 1000)));
}

}  // namespace

void add_options(CLI::App& command, ValidateOptions& options) {
  command.add_option(
      "command", options.command,
      "The implementation: a program that answers asks on its standard input, and its arguments");
  command.add_option("--engine", options.engine, "Judge an engine of this program instead");
  command.add_option("--library", options.library,
                     "Judge a shared library instead (groundtruth_implementation.h)");
  add_tolerance_options(command, options.tolerance);
  command.add_option("--cases", options.cases, "How many cases [20000; with --time, no end]");
  command.add_option("--time", options.seconds, "Seconds after which no more is asked")
      ->check(CLI::Range(0.0, 1e9));
  command.add_option("--seed", options.seed, "Of the generated cases")->capture_default_str();
  command.add_option("--jobs", options.jobs, "Workers, each with a process of the implementation")
      ->check(CLI::Range(1U, 1024U))
      ->capture_default_str();
  command.add_option("--timeout", options.patience, "Seconds that an ask may take")
      ->check(CLI::Range(0.001, 1e6))
      ->capture_default_str();
  command.add_option("--shard", options.shard, "Only part I of N, written I/N")->capture_default_str();
  command.add_option("--only", options.only, "Kinds of ask: entry,clip,step")
      ->delimiter(',')
      ->check(CLI::IsMember({"entry", "clip", "step"}));
  command.add_option("--failures", options.most_failures, "About how many failures to look for; 0: all")
      ->capture_default_str();
  command.add_flag(
      "--keep-going", [&options](std::int64_t) { options.most_failures = 0; }, "--failures 0");
  command
      .add_option("--shrink", options.shrinking,
                  "Seconds to look for smallest failures; 0: show them as found")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  command.add_option("--known", options.known, "File of known failures: only others count, and passes");
  command.add_flag("--update-known", options.update_known, "Write the failures found to that file");
  command.add_option("--json", options.json, "File for JSON Lines, written as they are found; - is stdout");
  command.add_option("--junit", options.junit, "File for a report as JUnit writes them");
  command.add_option("--html", options.html, "File for a page that explains each group of failures");
  command.add_option("--replay", options.replay, "Ask only this case, or those of this file");
}

std::optional<std::string> problem_with(const ValidateOptions& options) {
  const int ways = (options.command.empty() ? 0 : 1) + (options.engine.empty() ? 0 : 1) +
                   (options.library.empty() ? 0 : 1);
  if (ways == 0) return "nothing to judge: give -- COMMAND, --engine or --library";
  if (ways > 1) return "give one of -- COMMAND, --engine and --library";
  if (!shard_in(options.shard)) return fmt::format("--shard: {} is not I/N with 1 <= I <= N", options.shard);
  if (options.update_known && options.known.empty()) return "--update-known: give --known FILE as well";
  return std::nullopt;
}

Kinds kinds_of(const ValidateOptions& options, const implementations::Greeting& greeting) {
  Kinds kinds{greeting.entry, greeting.clip, greeting.step};
  if (options.only.empty()) return kinds;
  Kinds asked{};
  for (const std::string& kind : options.only) asked[static_cast<std::size_t>(*kind_named(kind))] = true;
  for (std::size_t i = 0; i < kinds.size(); ++i) kinds[i] = kinds[i] && asked[i];
  return kinds;
}

Selection selection_of(const ValidateOptions& options, const Kinds& kinds) {
  constexpr std::uint64_t usual = 20000;
  Selection selection;
  selection.seed = options.seed;
  selection.cases = options.cases;
  if (!options.cases && !options.seconds) selection.cases = usual;
  selection.shard = *shard_in(options.shard);
  selection.most_failures = options.most_failures;
  Shares& shares = selection.shares;
  if (!kinds[0]) shares.entry = 0;
  if (!kinds[1]) shares.clip = 0;
  if (!kinds[2]) shares.step = 0;
  return selection;
}

RunPlan run_plan_of(const ValidateOptions& options, const Kinds& kinds) {
  RunPlan plan;
  plan.tolerance = tolerance_of(options.tolerance);
  plan.kinds = kinds;
  plan.jobs = options.jobs;
  if (options.seconds) plan.time = milliseconds(*options.seconds);
  return plan;
}

SearchPlan search_plan_of(const ValidateOptions& options) {
  return {tolerance_of(options.tolerance), milliseconds(options.shrinking)};
}

std::unique_ptr<implementations::Subject> subject_of(const ValidateOptions& options) {
  implementations::Patience patience;
  patience.per_ask = milliseconds(options.patience);
  auto subject = !options.engine.empty()    ? implementations::engine_subject(options.engine)
                 : !options.library.empty() ? implementations::load_library(options.library, patience)
                                            : implementations::run_command(options.command, patience);
  if (const auto* none = std::get_if<implementations::NoSubject>(&subject)) {
    throw std::runtime_error("nothing to judge: " + none->problem);
  }
  return std::get<std::unique_ptr<implementations::Subject>>(std::move(subject));
}

std::string replay_command_of(const ValidateOptions& options, const std::string& id) {
  std::string command = "groundtruth validate";
  if (options.tolerance.profile != "exact") command += " --profile " + options.tolerance.profile;
  if (options.tolerance.metres) command += fmt::format(" --tolerance {}", *options.tolerance.metres);
  if (options.tolerance.ulps) command += fmt::format(" --ulps {}", *options.tolerance.ulps);
  if (options.tolerance.strict) command += " --strict";
  command += " --replay " + for_shell(id);
  if (!options.engine.empty()) return command + " --engine " + for_shell(options.engine);
  if (!options.library.empty()) return command + " --library " + for_shell(options.library);
  command += " --";
  for (const std::string& word : options.command) command += " " + for_shell(word);
  return command;
}

}  // namespace groundtruth::cli
