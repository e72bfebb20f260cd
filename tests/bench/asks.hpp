#pragma once
// The asks that are timed: always the same.

#include <cstdint>
#include <vector>

#include <groundtruth/problem/ask.hpp>

namespace groundtruth::bench {

// Metres; struts are asked about between these heights.
struct Extent {
  double width = 0;  // along x, from 0 (or around 0 for a negative start)
  double depth = 0;  // along y
  double start = 0;  // of both
  double low = 0;    // z
  double high = 0;
};

// 1 to 3 m, within 0.2 of vertical, anywhere in the extent.
std::vector<EntryAsk> struts(const Extent& extent, std::size_t count);
// Three wheels that roll over the extent, 2 cm a step: each strut is near its last.
std::vector<EntryAsk> taxi(const Extent& extent, std::size_t count);
// 100 m to 1 km through the extent, in any direction but slanting down a little.
std::vector<EntryAsk> long_ones(const Extent& extent, std::size_t count);

}  // namespace groundtruth::bench
