#include <algorithm>
#include <filesystem>
#include <memory>

#include <fmt/core.h>

#include <groundtruth/judge/verdict.hpp>
#include <groundtruth/report/judge_report.hpp>
#include <groundtruth/text/answer_text.hpp>
#include <groundtruth/text/ask_text.hpp>
#include <groundtruth/text/scene_text.hpp>

#include "answer_lines.hpp"
#include "subcommand.hpp"
#include "tolerance_options.hpp"

namespace groundtruth::cli {
namespace {

using judge::Judge;
using report::Judged;
using report::JudgedAsk;

struct Options {
  std::string asks;
  std::string answers;
  ToleranceOptions tolerance;
  bool json = false;
};

class Session {
 public:
  explicit Session(const Options& options)
      : options_(options), tolerance_(tolerance_of(options.tolerance)), answers_(options.answers) {
    use({{}, {Nothing{}}});
  }

  // The verdict on the answer to this line of the asks; absent if no answer is due.
  std::optional<JudgedAsk> judge(const std::string& line, std::size_t number) {
    place_ = {options_.asks, number};
    return std::visit([this](const auto& read) { return this->on(read); }, read_line(line, place_));
  }

  std::size_t left_over() const { return answers_.left_over(); }

 private:
  std::optional<JudgedAsk> on(const HelloLine&) { return std::nullopt; }
  std::optional<JudgedAsk> on(const SceneLine& line) {
    use(line.scene);
    return std::nullopt;
  }
  std::optional<JudgedAsk> on(const SceneFileLine& line) {
    try {
      use(read_scene_file((std::filesystem::path(options_.asks).parent_path() / line.file).string()));
      return std::nullopt;
    } catch (const BadInput& bad) {
      return on(BadSceneLine{bad.what()});
    }
  }
  std::optional<JudgedAsk> on(const BadSceneLine& line) { return on(BadLine{"null", line.problem}); }
  std::optional<JudgedAsk> on(const BadLine& line) {
    return judged(line.id, "bad", EntryAsk{}, [&](const AnswerLine& answer) {
      judge::Verdict verdict;
      if (std::holds_alternative<Refusal>(answer.answer)) return verdict;
      verdict.difference = judge::Difference::refusal;
      verdict.explanation = "an answer -> error (" + line.problem + ")";
      return verdict;
    });
  }
  std::optional<JudgedAsk> on(const AskLine& line) {
    return judged(line.id, std::string(kind_of(line.ask)), line.ask, [&](const AnswerLine& answer) {
      const auto* refusal = std::get_if<Refusal>(&answer.answer);
      const Answer got = refusal ? Answer(StepAnswer{*refusal}) : std::get<Answer>(answer.answer);
      return judge_->judge(line.ask, got);
    });
  }

  template <typename JudgeIt>
  JudgedAsk judged(const std::string& id, const std::string& kind, const Ask& ask, const JudgeIt& judge_it) {
    JudgedAsk asked{id, kind, fmt::format("{}:{}", place_.place, place_.first_line), Judged::skipped, {},
                    "", ""};
    const auto line = answers_.take(id);
    if (!line) {
      asked.explanation = "no line answers it";
      return asked;
    }
    try {
      asked.verdict = judge_it(read_answer(line->text, ask, scene_, {options_.answers, line->number}));
      asked.judged = asked.verdict.is_accepted() ? Judged::accepted : Judged::wrong;
      asked.explanation = asked.verdict.explanation;
      if (kind != "bad") asked.exact = exact_in_json(id, asked.verdict);
    } catch (const BadInput& bad) {
      asked.judged = Judged::unreadable;
      asked.explanation = bad.what();
    }
    return asked;
  }

  // The exact answer's line without its id.
  std::string exact_in_json(const std::string& id, const judge::Verdict& verdict) const {
    const std::string before = "{\"id\":" + id + ",";
    return "{" + write_answer(id, verdict.exact, verdict.evidence, scene_).substr(before.size());
  }

  void use(Scene scene) {
    scene_ = std::move(scene);
    judge_ = std::make_unique<const Judge>(scene_, tolerance_);
  }

  const Options& options_;
  judge::Tolerance tolerance_;
  AnswerLines answers_;
  Origin place_;
  Scene scene_;
  std::unique_ptr<const Judge> judge_;
};

std::size_t count(const std::vector<JudgedAsk>& asked, Judged judged, const std::string& kind = "") {
  return static_cast<std::size_t>(std::count_if(asked.begin(), asked.end(), [&](const JudgedAsk& one) {
    return one.judged == judged && (kind.empty() || one.kind == kind);
  }));
}

// A kind of ask of which some are answered and some are not: answers are missing. A kind that is never
// answered is one that the implementation does not know.
bool answers_are_missing(const std::vector<JudgedAsk>& asked) {
  for (const char* kind : {"entry", "clip", "step", "bad"}) {
    const std::size_t skipped = count(asked, Judged::skipped, kind);
    const auto all =
        std::count_if(asked.begin(), asked.end(), [&](const JudgedAsk& one) { return one.kind == kind; });
    if (skipped > 0 && skipped < static_cast<std::size_t>(all)) return true;
  }
  return false;
}

Exit exit_of(const std::vector<JudgedAsk>& asked, std::size_t left_over) {
  if (count(asked, Judged::wrong) > 0) return Exit::disagrees;
  if (count(asked, Judged::unreadable) > 0) return Exit::unreadable;
  if (left_over > 0) return Exit::disagrees;
  if (count(asked, Judged::accepted) == 0) return Exit::nothing_judged;
  return answers_are_missing(asked) ? Exit::disagrees : Exit::agrees;
}

Exit run(const Options& options) {
  const std::vector<std::string> lines = read_lines(options.asks);
  Session session(options);
  std::vector<JudgedAsk> asked;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    auto judged = session.judge(lines[i], i + 1);
    if (!judged) continue;
    if (options.json) fmt::print("{}", report::json_of(*judged));
    const bool worth_a_line = judged->judged == Judged::wrong || judged->judged == Judged::unreadable;
    if (!options.json && worth_a_line) fmt::print("{}", report::line_of(*judged));
    asked.push_back(std::move(*judged));
  }
  if (options.json) {
    fmt::print("{}", report::json_summary_of(asked, session.left_over()));
  } else {
    fmt::print("{}{}", in_words(options.tolerance), report::table_of(asked));
    if (session.left_over() > 0)
      fmt::print("{}: {} lines answer nothing that was asked\n", options.answers, session.left_over());
  }
  return exit_of(asked, session.left_over());
}

}  // namespace

Subcommand add_judge(CLI::App& program) {
  CLI::App* command = program.add_subcommand("judge", "Judges answers that were made elsewhere");
  const auto options = std::make_shared<Options>();
  command->add_option("asks", options->asks, "The file of asks")->required();
  command->add_option("answers", options->answers, "The file of answers, a line an ask")->required();
  add_tolerance_options(*command, options->tolerance);
  command->add_flag("--json", options->json,
                    "One JSON object an ask, with the exact answer, and a last one that sums up");
  return {command, [options] { return run(*options); }};
}

}  // namespace groundtruth::cli
