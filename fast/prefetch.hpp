#pragma once
// Memory that asks will look at, asked to come closer before they do. Not installed.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <groundtruth/fast/grid_probe.hpp>
#include <groundtruth/fast/scene.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::fast {

// Only what the grid knows can be told beforehand: of a range that it does not serve, nothing is fetched. Nor
// is what was fetched a moment ago: asks that follow each other through a scene cost next to nothing.
class Prefetcher {
 public:
  static constexpr std::size_t most_asks = 16;

  explicit Prefetcher(const Scene& scene);

  // For at most most_asks of them: all wait for the memory together, once for each of four links from the
  // square to the half-spaces.
  void fetch(std::span<const EntryAsk> asks);

 private:
  static constexpr std::size_t most_parts = 4;  // of one ask
  static constexpr std::size_t recent_squares = 256;
  static constexpr std::uint32_t no_square = 0xffffffff;

  struct InFlight {
    std::uint32_t square, first_entry, end_entry;
    std::uint64_t here;  // the range in it
  };

  void add(const EntryAsk& ask);
  void fetch_entries();
  void fetch_cells();
  void fetch_half_spaces() const;

  const Parts& parts_;
  bool is_large_;  // else it is in the cache anyway
  std::array<std::uint32_t, recent_squares> recent_;
  std::size_t ask_count_ = 0, part_count_ = 0;
  InFlight asks_[most_asks];
  Part cells_[most_asks * most_parts];
};

}  // namespace groundtruth::fast
