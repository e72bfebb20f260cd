#pragma once
// Independent pieces of work, shared out over threads.

#include <cstdint>
#include <functional>

namespace groundtruth::stability {

// Does work(i) for i in [0, count), each once, in any order; `progress` is called from one thread only.
// Requires work that does not throw.
void share_out(std::size_t count, unsigned jobs, const std::function<void(std::size_t)>& work,
               const std::function<void(std::uint64_t done, std::uint64_t all)>& progress);

}  // namespace groundtruth::stability
