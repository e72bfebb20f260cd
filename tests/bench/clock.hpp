#pragma once
// Time that this thread had a processor: what others do on the machine is left out, but for the caches.

#include <ctime>

namespace groundtruth::bench {

inline double nanoseconds_so_far() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e9 + static_cast<double>(now.tv_nsec);
}

}  // namespace groundtruth::bench
