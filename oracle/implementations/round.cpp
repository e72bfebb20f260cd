#include <groundtruth/implementations/round.hpp>

#include <algorithm>

#include <groundtruth/implementations/one_line.hpp>
#include <groundtruth/text/answer_text.hpp>
#include <groundtruth/text/ask_text.hpp>

namespace groundtruth::implementations {
Round::Round(Connection& connection, Record& record, const Scene& scene, std::span<const Ask> asks)
    : connection_(connection),
      record_(record),
      scene_(scene),
      asks_(asks),
      scene_line_(write_scene_line(scene)),
      first_id_(record.next_id) {
  record_.next_id += asks.size();
  replies_.reserve(asks.size());
}

std::string Round::id_of(std::size_t ask) const { return "\"a" + std::to_string(first_id_ + ask) + "\""; }

std::vector<Reply> Round::run() {
  if (asks_.empty()) return {};
  listen_before_asking();
  while (due() < asks_.size()) {
    if (connection_.is_lost()) start();
    say_more();
    Dialogue& dialogue = connection_.dialogue();
    if (const auto line = dialogue.next_line()) {
      hear(*line);
    } else if (dialogue.is_line_too_long()) {
      on_long_line();
    } else if (dialogue.is_over()) {
      on_end();
    } else if (const auto deadline = last_news_ + connection_.patience().per_ask; Clock::now() < deadline) {
      dialogue.exchange(deadline);
    } else {
      on_silence();
    }
  }
  clear_suspicions();
  listen_after_asking();
  return std::move(replies_);
}

void Round::start() {
  connection_.restart();
  said_ = due();
  answered_ = 0;
  last_news_ = Clock::now() + connection_.time_to_start();
}

// One at a time while we look for the ask at fault, and until a process started after a failure has answered.
std::size_t Round::window() const {
  constexpr std::size_t full = 512;
  const bool is_on_trial = record_.failures_in_a_row > 0 || !suspicions_.empty();
  return is_on_trial ? 1 : full;
}

void Round::say_more() {
  constexpr std::size_t enough = std::size_t{1} << 16;
  Dialogue& dialogue = connection_.dialogue();
  const std::size_t end = std::min(asks_.size(), due() + window());
  for (; said_ < end && dialogue.unsent() < enough; ++said_) {
    connection_.say_scene(scene_line_);
    dialogue.say(write_ask(id_of(said_), asks_[said_]));
  }
}

void Round::reply(Reply reply) {
  replies_.push_back(std::move(reply));
  last_news_ = Clock::now();
  clear_suspicions();
}

void Round::unreadable(std::string_view line, const std::string& why) {
  reply({ReplyKind::unreadable, {}, {}, shortened(line), one_line(why)});
}

// Those whose asks in flight have all been asked again, and none of them failed so alone.
void Round::clear_suspicions() {
  std::erase_if(suspicions_, [this](const Suspicion& suspicion) {
    if (suspicion.last >= due()) return false;
    Reply& reply = replies_[suspicion.ask];
    const char* note = suspicion.last > suspicion.ask
                           ? "; only with more asks in flight, not when they are asked one by one"
                           : "; not when it is asked first of a new process";
    reply = {suspicion.kind, {}, {}, std::move(reply.text), suspicion.how + note};
    return true;
  });
}

}  // namespace groundtruth::implementations
