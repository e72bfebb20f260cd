#pragma once
// What a compiled scene holds.

#include <cstddef>

#include <groundtruth/fast/scene.hpp>

namespace groundtruth::bench {

// On the heap, by capacity.
std::size_t bytes_of(const fast::Scene& scene);

// Of this process so far, resident, in bytes.
std::size_t peak_memory();

}  // namespace groundtruth::bench
