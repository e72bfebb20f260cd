#include <algorithm>
#include <memory>
#include <set>

#include <fmt/core.h>

#include <groundtruth/report/validation_report.hpp>
#include <groundtruth/validation/log.hpp>

#include "subcommand.hpp"
#include "validation_files.hpp"

namespace groundtruth::cli {
namespace {

using namespace validation;

struct Options {
  std::vector<std::string> files;
  std::string junit;
};

struct Whole {
  Tally tally;
  std::vector<Record> records;
  double seconds = 0;
  std::vector<std::string> gaps;  // what there should be, and is not; each a line
};

bool is_of_the_same_run(const Head& left, const Head& right) {
  return left.subject == right.subject && left.seed == right.seed && left.cases == right.cases &&
         left.shard.count == right.shard.count && left.tolerance == right.tolerance;
}

// Adds what is missing for the logs to be one whole run.
void find_gaps(const std::vector<Log>& logs, std::vector<std::string>& gaps) {
  const Head& first = logs.front().head;
  std::set<std::uint64_t> shards;
  for (const Log& log : logs) {
    if (!is_of_the_same_run(first, log.head)) {
      gaps.push_back(log.file + ": is of another run than " + logs.front().file);
    }
    if (!shards.insert(log.head.shard.index).second) {
      gaps.push_back(fmt::format("{}: shard {} is there twice", log.file, log.head.shard.index));
    }
    if (!log.summary) gaps.push_back(log.file + ": was cut off: it has no summary");
    if (log.summary && log.summary->ending == "interrupted") gaps.push_back(log.file + ": was interrupted");
  }
  for (std::uint64_t shard = 1; shard <= first.shard.count; ++shard) {
    if (shards.count(shard) == 0) gaps.push_back(fmt::format("shard {} is missing", shard));
  }
}

Whole joined(const std::vector<Log>& logs) {
  Whole whole;
  for (const Log& log : logs) {
    whole.records.insert(whole.records.end(), log.records.begin(), log.records.end());
    if (!log.summary) continue;
    whole.tally.merge(log.summary->tally);
    whole.seconds = std::max(whole.seconds, log.summary->seconds);
  }
  find_gaps(logs, whole.gaps);
  return whole;
}

Exit run(const Options& options) {
  std::vector<Log> logs;
  for (const std::string& file : options.files) logs.push_back(read_log(file));
  const Whole whole = joined(logs);
  const Head& head = logs.front().head;
  fmt::print("{}; seed {}; {} files\n{}\n{}", head.subject, head.seed, logs.size(), head.tolerance,
             report::table_of(whole.tally));
  fmt::print("{}", report::failures_of(whole.records, [](const std::string& id) {
               return "groundtruth validate --replay '" + id + "' ...";
             }));
  if (!options.junit.empty()) write_text(options.junit, report::junit_of(whole.tally, whole.records));
  for (const std::string& gap : whole.gaps) fmt::print(stderr, "groundtruth merge: {}\n", gap);
  const Conclusion conclusion = conclude(whole.tally, whole.records);
  const bool is_unfinished = !whole.gaps.empty() && conclusion == Conclusion::agrees;
  fmt::print("\n{}: {} of {} cases failed; seed {}; the longest took {:.1f} s\n",
             is_unfinished ? "INCOMPLETE" : in_words(conclusion), whole.records.size(), whole.tally.judged(),
             head.seed, whole.seconds);
  return is_unfinished ? Exit::unreadable : exit_of(conclusion);
}

}  // namespace

Subcommand add_merge(CLI::App& program) {
  CLI::App* command = program.add_subcommand("merge", "Joins what the shards of a validation found");
  const auto options = std::make_shared<Options>();
  command->add_option("files", options->files, "What validate --shard I/N --json FILE wrote")->required();
  command->add_option("--junit", options->junit, "File for a report as JUnit writes them");
  return {command, [options] { return run(*options); }};
}

}  // namespace groundtruth::cli
