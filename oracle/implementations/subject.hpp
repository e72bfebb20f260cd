#pragma once
// An implementation under judgement, reached from outside: whatever it does, each ask gets one reply, and
// this process lives on.

#include <chrono>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/scene.hpp>

namespace groundtruth::implementations {

enum class ReplyKind {
  answered,    // `answer` holds what it said
  refused,     // it answered {"error": ...}; `detail` is the reason
  unreadable,  // the line that should answer is none; `detail` says why
  crashed,     // it ended before it answered; `detail` says how (signal, exit code)
  hung         // no answer in time
};

struct Reply {
  ReplyKind kind = ReplyKind::answered;
  Answer answer;
  Evidence evidence;   // of an implementation that gives some
  std::string text;    // the line as it came; empty if none
  std::string detail;  // one line; empty if answered
};

// What it said of itself.
struct Greeting {
  std::string name;
  bool entry = true;  // the kinds of ask that it answers
  bool clip = true;
  bool step = true;
};

class Subject {
 public:
  virtual ~Subject() = default;
  virtual const Greeting& greeting() const = 0;
  // One reply an ask, in order. Starts the implementation anew after a crash or a hang, and goes on with the
  // next ask. Not for several threads at once: each makes its own.
  virtual std::vector<Reply> ask(const Scene& scene, std::span<const Ask> asks) = 0;
  // The end of what it wrote to standard error so far.
  virtual std::string last_words() const = 0;
};

// It cannot be started, or does not speak the protocol at all.
struct NoSubject {
  std::string problem;
};

struct Patience {
  std::chrono::milliseconds per_ask{10000};  // since the reply before it
  std::chrono::milliseconds to_greet{5000};  // then it counts as one that knows no hello
};

using SubjectOrNone = std::variant<std::unique_ptr<Subject>, NoSubject>;

// A program that speaks JSON Lines (SPEC section 8) on its standard input and output; found on PATH.
SubjectOrNone run_command(const std::vector<std::string>& command, const Patience& patience);

// A shared library with the functions of groundtruth_implementation.h, run in a process of its own.
SubjectOrNone load_library(const std::string& path, const Patience& patience);

// An engine of this program (engine.hpp), in this process.
SubjectOrNone engine_subject(const std::string& engine);

}  // namespace groundtruth::implementations
