#pragma once
// The process between us and an implementation: it starts it and sees to it that nothing of it is left, even
// if we die first. Whatever the implementation forks becomes the keeper's child once its parent has ended, so
// that sessions and double forks hide nothing. Private to this folder.

#include <functional>
#include <string>

namespace groundtruth::implementations {

// What a child process runs. Returns only if it cannot start, with the reason.
using Entry = std::function<std::string()>;

// How it went, sent once over the keeper's status pipe.
struct Ending {
  enum class How { not_started, exited, killed_by_signal };
  How how = How::exited;
  int number = 0;          // exit code, or signal
  char problem[240] = {};  // why it was not started
};

// In the child, where its side of the status pipe is; it closes on exec.
inline constexpr int status_in_child = 3;

// The ends that the keeper and its child hold. `lifeline` ends when we close it, or die.
struct KeeperEnds {
  int input = -1;
  int output = -1;
  int errors = -1;
  int status = -1;
  int lifeline = -1;
};

// To be called after fork(), in a process with one thread. 1. All other descriptors are closed. 2. The child
// gets default signal handling and leads its own session. 3. When the child or the lifeline ends, whichever
// comes first, every descendant is killed and waited for; then the Ending is sent and the keeper exits.
[[noreturn]] void keep(const KeeperEnds& ends, const Entry& entry);

}  // namespace groundtruth::implementations
