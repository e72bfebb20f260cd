#include <groundtruth/implementations/one_line.hpp>
#include <groundtruth/implementations/round.hpp>
#include <groundtruth/text/answer_text.hpp>

namespace groundtruth::implementations {
namespace {

// After failures in a row of this weight together, the rest of the round is not asked any more.
constexpr int most_failures = 20;
constexpr int weight_of_crash = 1;
constexpr int weight_of_silence = 7;

}  // namespace

void Round::on_long_line() {
  const std::string_view line = connection_.dialogue().unfinished_line();
  unreadable(line, "a line longer than " + std::to_string(LineSplitter::longest_line) + " bytes");
  connection_.lose();
  after_failure(weight_of_crash);
}

void Round::on_end() {
  std::string how = connection_.dialogue().how_it_ended();
  const std::string unfinished = one_line(connection_.dialogue().unfinished_line());
  if (!unfinished.empty()) how += " in the middle of a line: " + unfinished;
  connection_.lose();
  const bool is_its_own_doing = said_ - due() <= 1 && answered_ == 0;
  if (is_its_own_doing) {
    blame_due_ask(ReplyKind::crashed, how);
  } else {
    suspicions_.push_back({due(), said_ - 1, ReplyKind::crashed, how});
  }
  after_failure(weight_of_crash);
}

void Round::blame_due_ask(ReplyKind kind, const std::string& how) {
  // An ask that fails alone also explains the failure that led here.
  std::erase_if(suspicions_, [this](const Suspicion& suspicion) { return suspicion.last >= due(); });
  reply({kind, {}, {}, {}, how});
}

// Ends its input, to see whether the answer was only waiting in a buffer.
std::string Round::hint_at_silence() {
  constexpr std::chrono::milliseconds last_moments(200);
  const std::string flush = "does it flush its output after every line?";
  Dialogue& dialogue = connection_.dialogue();
  const std::string unfinished = one_line(dialogue.unfinished_line());
  const bool was_mute = dialogue.received() == 0;
  dialogue.hang_up();
  const auto until = Clock::now() + last_moments;
  while (!dialogue.is_over() && !dialogue.is_line_too_long() && Clock::now() < until) {
    dialogue.exchange(until);
    while (const auto line = dialogue.next_line()) {
      if (read_id(*line) == id_of(due()))
        return "; it came just after the input was closed: is it slow, or " + flush;
    }
  }
  if (was_mute) return "; nothing has come at all: " + flush;
  return unfinished.empty() ? "" : "; this line has no end: " + unfinished;
}

void Round::on_silence() {
  const auto waited = std::to_string(connection_.patience().per_ask.count());
  const std::string detail = "no answer within " + waited + " ms" + hint_at_silence();
  connection_.lose();
  const bool is_its_own_doing = said_ - due() <= 1;
  if (is_its_own_doing) {
    blame_due_ask(ReplyKind::hung, detail);
  } else {
    suspicions_.push_back({due(), said_ - 1, ReplyKind::hung, detail});
  }
  after_failure(weight_of_silence);
}

void Round::after_failure(int weight) {
  record_.failures_in_a_row += weight;
  if (record_.failures_in_a_row < most_failures) return;
  record_.failures_in_a_row = most_failures;  // the next round has one try
  suspicions_.clear();
  if (replies_.empty()) return;
  const Reply last{replies_.back().kind,
                   {},
                   {},
                   {},
                   "not asked after failures in a row; the last: " + replies_.back().detail};
  while (due() < asks_.size()) reply(last);
}

}  // namespace groundtruth::implementations
