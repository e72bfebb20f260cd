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
  unreadable,  // not one readable line with its id, in its turn; `detail` says why
  crashed,     // it ended before it answered; `detail` says how (signal, exit code)
  hung         // no answer in time; `detail` guesses why
};

struct Reply {
  ReplyKind kind = ReplyKind::answered;
  Answer answer;
  Evidence evidence;   // of an implementation that gives some
  std::string text;    // the line as it came, the first 64 KiB of it; empty if none
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
  // Of one that says no hello in time: nameless, and all kinds; what it says later still counts.
  virtual const Greeting& greeting() const = 0;
  // 1. One reply an ask, in order. 2. Asks are written ahead; whoever crashes or hangs is started anew, and
  // goes on with the next ask. 3. A crash is laid to the ask that crashes it alone. If there is none, the
  // first unanswered ask is `crashed` and its `detail` says that it answers when asked alone. 4. After 20
  // crashes or 3 silences in a row the rest of the asks get the same reply without being asked; the next call
  // tries again. Not for several threads at once: each makes its own. The scene is written out in every call.
  virtual std::vector<Reply> ask(const Scene& scene, std::span<const Ask> asks) = 0;
  // The end of what it wrote to standard error so far, over all its starts; 4 KiB at most.
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

// A program that speaks JSON Lines (SPEC section 8) on its standard input and output; found on PATH. It runs
// in a session of its own. With the Subject it ends: its input is closed, and half a second later it is
// killed, with everything that it started, however detached. The same happens if this process is killed.
SubjectOrNone run_command(const std::vector<std::string>& command, const Patience& patience);

// A shared library with the functions of groundtruth_implementation.h, run in a process of its own.
SubjectOrNone load_library(const std::string& path, const Patience& patience);

// An engine of this program (engine.hpp), in this process.
SubjectOrNone engine_subject(const std::string& engine);

}  // namespace groundtruth::implementations
