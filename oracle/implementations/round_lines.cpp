#include <algorithm>
#include <charconv>

#include <groundtruth/implementations/one_line.hpp>
#include <groundtruth/implementations/round.hpp>
#include <groundtruth/text/answer_text.hpp>

namespace groundtruth::implementations {
namespace {

// Of an ask in the life of a subject; absent: we never gave this id.
std::optional<std::uint64_t> number_in(const std::string& id) {
  constexpr std::string_view prefix = "\"a";
  if (!id.starts_with(prefix) || !id.ends_with('"')) return std::nullopt;
  std::uint64_t number = 0;
  const char* last = id.data() + id.size() - 1;
  const auto [end, error] = std::from_chars(id.data() + prefix.size(), last, number);
  if (error != std::errc{} || end != last) return std::nullopt;
  return number;
}

std::string without_place(const std::string& problem) {
  constexpr std::string_view place = "answer:1: ";
  return problem.starts_with(place) ? problem.substr(place.size()) : problem;
}

Reply reply_of(AnswerLine read, std::string_view line) {
  if (const auto* refusal = std::get_if<Refusal>(&read.answer)) {
    return {ReplyKind::refused, {}, {}, shortened(line), one_line(refusal->reason)};
  }
  return {ReplyKind::answered,
          std::get<Answer>(std::move(read.answer)),
          std::move(read.evidence),
          shortened(line),
          {}};
}

// What has come by now, and not without end.
void receive_at_once(Dialogue& dialogue) {
  constexpr int enough = 16;
  std::size_t before = 0;
  for (int i = 0; i < enough; ++i) {
    before = dialogue.received();
    dialogue.exchange(Clock::now());
    if (dialogue.received() == before) return;
  }
}

}  // namespace

void Round::hear(std::string_view line) {
  try {
    AnswerLine read = read_answer(line, asks_[due()], scene_, {"answer"});
    if (read.id != id_of(due())) return hear_out_of_turn(line, "");
    record_.failures_in_a_row = 0;
    ++answered_;
    reply(reply_of(std::move(read), line));
  } catch (const BadInput& bad) {
    hear_out_of_turn(line, without_place(bad.what()));
  }
}

void Round::hear_out_of_turn(std::string_view line, const std::string& problem) {
  const std::string id = read_id(line);
  if (const auto number = number_in(id)) {
    if (*number < first_id_) return;  // too late: its ask has had its reply
    const auto ask = static_cast<std::size_t>(*number - first_id_);
    if (ask < due()) return hear_again(ask, line);
    if (ask == due()) return unreadable(line, problem);
    if (ask < said_) return hear_early(ask, line);
  }
  if (connection_.is_hello(line)) return;
  const std::string strange = "its id, " + id + ", is none of those asked: " + one_line(line);
  unreadable(line, problem.empty() ? strange : problem);
}

void Round::hear_early(std::size_t ask, std::string_view line) {
  while (due() < ask) unreadable(line, "out of order: in place of its answer came " + id_of(ask) + "'s");
  hear(line);
}

void Round::hear_again(std::size_t ask, std::string_view line) {
  Reply& reply = replies_[ask];
  const bool was_heard = reply.kind == ReplyKind::answered || reply.kind == ReplyKind::refused;
  if (was_heard) reply = {ReplyKind::unreadable, {}, {}, reply.text, "answered again: " + one_line(line)};
}

void Round::listen_before_asking() {
  last_news_ = Clock::now();
  premature_ = connection_.take_premature();
  if (connection_.is_lost()) return;
  receive_at_once(connection_.dialogue());
  while (const auto line = connection_.dialogue().next_line()) {
    const auto number = number_in(read_id(*line));
    const bool is_late = number && *number < first_id_;
    if (!is_late && premature_.empty() && !connection_.is_hello(*line)) premature_ = one_line(*line);
  }
}

void Round::listen_after_asking() {
  if (!premature_.empty() && replies_.front().kind == ReplyKind::answered) {
    Reply& first = replies_.front();
    first = {ReplyKind::unreadable, {}, {}, first.text, "before it was asked came: " + premature_};
  }
  if (connection_.is_lost()) return;
  receive_at_once(connection_.dialogue());
  while (const auto line = connection_.dialogue().next_line()) {
    const auto number = number_in(read_id(*line));
    if (number && *number < first_id_) continue;
    const bool is_known = number && *number - first_id_ < replies_.size();
    if (is_known) {
      hear_again(static_cast<std::size_t>(*number - first_id_), *line);
    } else if (!connection_.is_hello(*line)) {
      hear_again(replies_.size() - 1, *line);
    }
  }
}

}  // namespace groundtruth::implementations
