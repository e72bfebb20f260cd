#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>

#include <fmt/core.h>

#include <groundtruth/report/cause_report.hpp>
#include <groundtruth/report/validation_report.hpp>
#include <groundtruth/validation/known_failures.hpp>
#include <groundtruth/validation/log.hpp>
#include <groundtruth/validation/replay.hpp>

#include "failure_pages.hpp"
#include "interrupt.hpp"
#include "progress_bar.hpp"
#include "subcommand.hpp"
#include "validate_options.hpp"
#include "validation_files.hpp"

namespace groundtruth::cli {
namespace {

using namespace validation;

std::string_view in_words(Ending ending) {
  switch (ending) {
    case Ending::all_asked:
      return "all asked";
    case Ending::enough_failed:
      return "enough failed, the rest was not asked";
    case Ending::out_of_time:
      return "out of time";
    case Ending::interrupted:
      return "interrupted";
    default:
      return "stopped: too many asks hung";
  }
}

// One run, from the first ask to the last line.
class Validation {
 public:
  explicit Validation(const ValidateOptions& options)
      : options_(options),
        out_(options.json == "-" ? stderr : stdout),
        first_subject_(subject_of(options)),
        kinds_(kinds_of(options, first_subject_->greeting())),
        selection_(selection_of(options, kinds_)),
        subject_name_(first_subject_->greeting().name) {
    const bool is_new_list = options.update_known && !std::filesystem::exists(options.known);
    if (!options.known.empty() && !is_new_list) known_ = read_known_failures(options.known);
    if (!options.replay.empty()) given_ = cases_to_replay(options.replay);
  }

  Exit run() {
    LineFile json(options_.json);
    json.write(write_head(head()));
    introduce();
    Watch watch;
    watch.interrupted = &watch_for_interrupts();
    watch.judged = [&](std::uint64_t judged) { bar_.show("judged", judged, expected_cases()); };
    watch.failed = [&](const Failure& failure) { note(record_of(failure), json); };
    const Result result = validation::run(
        run_plan_of(options_, kinds_), course(), [this] { return take_subject(); }, watch);
    bar_.clear();
    if (options_.update_known) update_known();
    for (const Record& record : passing_) note_passing(record, json);
    const std::optional<Causes> causes = look_for_causes(result, json);
    json.write(write_summary({result.tally, std::string(in_words(result.ending)), result.seconds}));
    if (!options_.junit.empty()) write_text(options_.junit, report::junit_of(result.tally, records_));
    if (!options_.html.empty()) explain(result, causes);
    return conclude(result, causes);
  }

 private:
  Head head() const {
    return {subject_name_, options_.seed, selection_.cases.value_or(0), selection_.shard,
            in_words(options_.tolerance)};
  }

  std::string name_of_subject() const {
    return subject_name_.empty() ? "an implementation without a name" : subject_name_;
  }

  void introduce() const {
    fmt::print(out_, "{}; seed {}", name_of_subject(), options_.seed);
    if (selection_.shard.count > 1) fmt::print(out_, "; shard {}", options_.shard);
    fmt::print(out_, "\n{}\n", cli::in_words(options_.tolerance));
    std::fflush(out_);
  }

  std::uint64_t expected_cases() const { return selection_.cases.value_or(1) / selection_.shard.count; }

  // The cases to replay; or the known failures and then all others.
  StreamAt course() {
    if (!options_.replay.empty()) {
      return [this](std::size_t stream) { return stream == 0 ? stream_of(given_) : nullptr; };
    }
    const StreamAt others = course_of(selection_);
    if (known_.failures().empty()) return others;
    return [this, others](std::size_t stream) { return stream == 0 ? known_stream() : others(stream - 1); };
  }

  std::unique_ptr<Stream> known_stream() {
    std::vector<cases::Case> mine;
    const std::vector<Record>& all = known_.failures();
    for (std::size_t i = selection_.shard.index - 1; i < all.size(); i += selection_.shard.count) {
      mine.push_back(case_of(all[i], {options_.known, i + 2}));
    }
    return stream_of(std::move(mine), [this](const std::string& id, const Finding& finding) {
      if (finding.outcome == Outcome::accepted) passing_.push_back(*known_.find(id));
    });
  }

  // Known failures are asked on their own, and may come again in their turn.
  void note(Record record, LineFile& json) {
    if (!seen_.insert(record.id).second) return;
    if (!options_.known.empty()) record.expectation = known_.expectation_of(record);
    json.write(write_record(record));
    records_.push_back(std::move(record));
  }

  void note_passing(Record record, LineFile& json) {
    record.outcome = Outcome::accepted;
    record.expectation = Expectation::passes;
    record.explanation = "is known to fail, and passes";
    json.write(write_record(record));
    records_.push_back(std::move(record));
  }

  void update_known() {
    write_known_failures(options_.known, records_);
    for (Record& record : records_) record.expectation = Expectation::known;
    passing_.clear();
    fmt::print(out_, "{}: {} known failures\n", options_.known, records_.size());
  }

  std::unique_ptr<implementations::Subject> take_subject() {
    if (first_subject_ != nullptr) return std::move(first_subject_);
    return subject_of(options_);
  }

  // Of what is not known to fail. Absent where none is looked for.
  std::optional<Causes> look_for_causes(const Result& result, LineFile& json) {
    if (options_.shrinking == 0 || result.ending == Ending::interrupted) return std::nullopt;
    std::vector<Failure> news;
    for (const Failure& failure : result.failures)
      if (!is_known(failure.asked.id)) news.push_back(failure);
    if (news.empty()) return std::nullopt;
    Causes causes = causes_of(news, result.accepted, *subject_of(options_), search_plan_of(options_));
    for (const Cause& cause : causes.groups) json.write(write_cause(cause));
    if (causes.diagnosis) json.write(write_diagnosis(*causes.diagnosis));
    return causes;
  }

  bool is_known(const std::string& id) const {
    return std::any_of(records_.begin(), records_.end(), [&](const Record& record) {
      return record.id == id && record.expectation == Expectation::known;
    });
  }

  void explain(const Result& result, const std::optional<Causes>& causes) const {
    std::vector<Failure> news;
    for (const Failure& failure : result.failures)
      if (!is_known(failure.asked.id)) news.push_back(failure);
    if (news.empty()) return;
    const auto sections =
        sections_of(causes, news, [this](const std::string& id) { return replay_command_of(options_, id); });
    write_text(options_.html, page::html_page(sections, "Where " + name_of_subject() + " differs"));
    fmt::print(out_, "{}", places_of(sections, options_.html));
  }

  Exit conclude(const Result& result, const std::optional<Causes>& causes) const {
    const auto known = std::count_if(records_.begin(), records_.end(), [](const Record& record) {
      return record.expectation == Expectation::known;
    });
    fmt::print(out_, "{}", report::table_of(result.tally));
    const auto replay_command = [this](const std::string& id) { return replay_command_of(options_, id); };
    fmt::print(
        out_, "{}",
        causes ? report::causes_of(*causes, replay_command) : report::failures_of(records_, replay_command));
    const Conclusion conclusion = validation::conclude(result.tally, records_);
    fmt::print(out_, "\n{}: {} of {} cases failed", validation::in_words(conclusion), records_.size(),
               result.tally.judged());
    if (!options_.known.empty()) fmt::print(out_, ", {} of them known", known);
    fmt::print(out_, "; seed {}; {}; {:.1f} s\n", options_.seed, in_words(result.ending), result.seconds);
    const bool is_cut_short = result.ending == Ending::interrupted && conclusion == Conclusion::agrees;
    return is_cut_short ? Exit::interrupted : exit_of(conclusion);
  }

  const ValidateOptions& options_;
  std::FILE* out_;
  std::unique_ptr<implementations::Subject> first_subject_;
  Kinds kinds_;
  Selection selection_;
  std::string subject_name_;
  KnownFailures known_;
  std::vector<cases::Case> given_;
  std::set<std::string> seen_;
  std::vector<Record> records_;
  std::vector<Record> passing_;
  ProgressBar bar_;
};

Exit run(const ValidateOptions& options) {
  if (const auto problem = problem_with(options)) {
    fmt::print(stderr, "groundtruth validate: {}\n", *problem);
    return Exit::usage;
  }
  return Validation(options).run();
}

}  // namespace

Subcommand add_validate(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("validate", "Judges an implementation: is it right, and if not, why?");
  const auto options = std::make_shared<ValidateOptions>();
  add_options(*command, *options);
  return {command, [options] { return run(*options); }};
}

}  // namespace groundtruth::cli
