#include <groundtruth/implementations/connection.hpp>

#include <algorithm>

#include <groundtruth/implementations/one_line.hpp>
#include <groundtruth/text/answer_text.hpp>

namespace groundtruth::implementations {
namespace {

constexpr std::string_view hello_line = R"({"hello":"answers/1"})";
constexpr std::string_view protocol = "answers/1";

std::optional<HelloAnswer> hello_in(std::string_view line) {
  try {
    return groundtruth::read_hello(line, {"hello"});
  } catch (const BadInput&) {
    return std::nullopt;
  }
}

bool is_error(std::string_view line) {
  try {
    const AnswerLine read = read_answer(line, EntryAsk{}, Scene{}, {"hello"});
    return std::holds_alternative<Refusal>(read.answer);
  } catch (const BadInput&) {
    return false;
  }
}

}  // namespace

void Connection::take_greeting(std::string_view line) {
  const HelloAnswer hello = *hello_in(line);
  if (hello.version != protocol) wrong_version_ = hello.version;
  greeting_.name = one_line(hello.name);
  knows_hello_ = true;
  if (!hello.asks) return;
  const auto answers = [&](std::string_view kind) {
    return std::find(hello.asks->begin(), hello.asks->end(), kind) != hello.asks->end();
  };
  greeting_ = {greeting_.name, answers("entry"), answers("clip"), answers("step")};
}

bool Connection::is_hello(std::string_view line) {
  if (!hello_in(line)) return false;
  if (!knows_hello_) take_greeting(line);
  return true;
}

std::optional<std::string> Connection::greet() {
  const auto beginning = Clock::now();
  const auto until = beginning + patience_.to_greet;
  dialogue_.emplace(entry_, words_);
  dialogue_->say(hello_line);
  bool is_done = false;
  while (!is_done && !dialogue_->is_over() && !dialogue_->is_line_too_long() && Clock::now() < until) {
    dialogue_->exchange(until);
    while (const auto line = is_done ? std::nullopt : dialogue_->next_line()) {
      is_done = is_hello(*line) || is_error(*line);
      if (!is_done && premature_.empty()) premature_ = one_line(*line);
    }
  }
  if (knows_hello_) first_start_ = Clock::now() - beginning;
  if (const auto why = dialogue_->why_not_started()) return why;
  if (!wrong_version_.empty()) {
    return "it speaks " + one_line(wrong_version_) + ", not " + std::string(protocol);
  }
  // Whoever does not survive a hello is asked without one.
  if (dialogue_->is_over() || dialogue_->is_line_too_long()) lose();
  return std::nullopt;
}

std::string Connection::take_premature() { return std::exchange(premature_, {}); }

void Connection::lose() {
  dialogue_->kill();
  dialogue_.reset();
}

void Connection::restart() {
  scene_.clear();
  dialogue_.emplace(entry_, words_);
  if (knows_hello_) dialogue_->say(hello_line);
}

void Connection::say_scene(const std::string& line) {
  if (line == scene_) return;
  dialogue_->say(line);
  scene_ = line;
}

}  // namespace groundtruth::implementations
