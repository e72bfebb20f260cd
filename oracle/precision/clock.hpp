#pragma once
// Time that this thread had a processor: what others do on the machine is left out, but for the caches.
// Private to this folder.

#include <ctime>

namespace groundtruth::precision {

inline double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

}  // namespace groundtruth::precision
