#pragma once
// Lines to and from one child, so that neither side's full pipe ever blocks the other. Private to this
// folder.

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

#include <groundtruth/implementations/child.hpp>
#include <groundtruth/implementations/line_splitter.hpp>

namespace groundtruth::implementations {

using Clock = std::chrono::steady_clock;

// The end of a text that grows.
class Tail {
 public:
  void add(std::string_view bytes);
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

class Dialogue {
 public:
  // What it writes to standard error is added to `words`.
  Dialogue(const Entry& entry, Tail& words) : child_(entry), words_(words) {}

  void say(std::string_view line);
  std::size_t unsent() const { return outbox_.size() - sent_; }
  // It reads its last line, and then the end of its input.
  void hang_up() { child_.input.close(); }

  // Ends it without grace.
  void kill() { child_.kill(); }

  // Sends and receives what can be, waiting for the first of it until then.
  void exchange(Clock::time_point until);

  std::optional<std::string_view> next_line() { return lines_.next(); }
  bool is_line_too_long() const { return lines_.is_too_long(); }
  std::string_view unfinished_line() const { return lines_.unfinished(); }
  std::size_t received() const { return received_; }  // bytes
  bool is_over() const { return !child_.output.is_open(); }

  // Of one that is over: what became of it.
  std::string how_it_ended();
  // Absent unless it never ran.
  std::optional<std::string> why_not_started();

 private:
  void send();
  void receive_output();
  void receive_errors();

  Child child_;
  Tail& words_;
  std::string outbox_;
  std::size_t sent_ = 0;
  LineSplitter lines_;
  std::size_t received_ = 0;
};

}  // namespace groundtruth::implementations
