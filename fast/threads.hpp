#pragma once
// How many threads may work.

#include <algorithm>
#include <thread>

namespace groundtruth::fast {

struct Threads {
  unsigned count = 1;  // the caller's own among them; 0 counts as 1

  // As many as the machine runs at a time.
  static Threads all() { return {std::max(1U, std::thread::hardware_concurrency())}; }
};

}  // namespace groundtruth::fast
