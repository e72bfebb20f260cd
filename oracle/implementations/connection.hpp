#pragma once
// An implementation in a process of its own that is started again whenever it is lost, and greeted once.
// Private to this folder.

#include <optional>
#include <string>

#include <groundtruth/implementations/dialogue.hpp>
#include <groundtruth/implementations/subject.hpp>

namespace groundtruth::implementations {

class Connection {
 public:
  Connection(Entry entry, Patience patience) : entry_(std::move(entry)), patience_(patience) {}

  // Starts it and asks for its greeting; without one it counts as an implementation of all kinds of ask that
  // knows no hello. Returns why it cannot be a subject, or nothing.
  std::optional<std::string> greet();
  const Greeting& greeting() const { return greeting_; }
  // Is this the answer to the hello, late or of a process started again?
  bool is_hello(std::string_view line);

  // What it wrote before anything was asked; empty if nothing. Told once.
  std::string take_premature();

  Dialogue& dialogue() { return *dialogue_; }
  bool is_lost() const { return !dialogue_; }
  // Kills it. It is started again by restart().
  void lose();
  void restart();
  // Sets the scene for what is said next.
  void say_scene(const std::string& line);

  const Patience& patience() const { return patience_; }
  // What it may need for a start again, by its first one.
  Clock::duration time_to_start() const { return 2 * first_start_; }
  const std::string& last_words() const { return words_.text(); }

 private:
  void take_greeting(std::string_view line);

  Entry entry_;
  Patience patience_;
  Tail words_;
  std::optional<Dialogue> dialogue_;
  Greeting greeting_;
  bool knows_hello_ = false;
  Clock::duration first_start_{};  // until the greeting came; 0 if none did
  std::string wrong_version_;
  std::string premature_;
  std::string scene_;  // the line last said to this process
};

}  // namespace groundtruth::implementations
