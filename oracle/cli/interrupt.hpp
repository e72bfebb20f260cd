#pragma once
// Ctrl-C as a wish, not as an end.

#include <atomic>

namespace groundtruth::cli {

// Becomes true at the first SIGINT or SIGTERM from now on; the second one ends the program.
const std::atomic<bool>& watch_for_interrupts();

}  // namespace groundtruth::cli
