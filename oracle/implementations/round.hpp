#pragma once
// One call of Subject::ask() on an implementation in another process: asks are written ahead, replies are
// found for all of them whatever happens. Private to this folder.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <groundtruth/implementations/connection.hpp>
#include <groundtruth/implementations/subject.hpp>

namespace groundtruth::implementations {

// How it has gone of late, over all rounds.
struct Record {
  std::uint64_t next_id = 1;
  int failures_in_a_row = 0;
};

class Round {
 public:
  Round(Connection& connection, Record& record, const Scene& scene, std::span<const Ask> asks);
  std::vector<Reply> run();

 private:
  // A crash that may be another ask's than the first unanswered one's: this is asked again alone, then those
  // that were in flight one by one.
  struct Suspicion {
    std::size_t ask;
    std::size_t last;  // in flight
    ReplyKind kind;    // crashed or hung
    std::string how;
  };

  std::string id_of(std::size_t ask) const;
  std::size_t due() const { return replies_.size(); }
  std::size_t window() const;
  void start();
  void say_more();
  void reply(Reply reply);
  void unreadable(std::string_view line, const std::string& why);
  void clear_suspicions();

  // round_lines.cpp: what is said.
  void listen_before_asking();
  void listen_after_asking();
  void hear(std::string_view line);
  void hear_out_of_turn(std::string_view line, const std::string& problem);
  void hear_early(std::size_t ask, std::string_view line);
  void hear_again(std::size_t ask, std::string_view line);

  // round_failures.cpp: what is not.
  void on_long_line();
  void on_end();
  void on_silence();
  void blame_due_ask(ReplyKind kind, const std::string& how);
  std::string hint_at_silence();
  void after_failure(int weight);

  Connection& connection_;
  Record& record_;
  const Scene& scene_;
  std::span<const Ask> asks_;
  std::string scene_line_;
  std::uint64_t first_id_;
  std::string premature_;

  std::vector<Reply> replies_;  // of the asks before the one that is due
  std::size_t said_ = 0;        // asks before this one are written
  std::size_t answered_ = 0;    // by this process
  Clock::time_point last_news_;
  std::vector<Suspicion> suspicions_;
};

}  // namespace groundtruth::implementations
