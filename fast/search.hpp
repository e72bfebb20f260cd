#pragma once
// Where a range first meets the parts of a solid, as far as doubles can tell. Not installed.

#include <groundtruth/fast/grid_probe.hpp>
#include <groundtruth/fast/range_ends.hpp>
#include <groundtruth/fast/scene.hpp>
#include <groundtruth/fast/search_task.hpp>
#include <groundtruth/fast/sieved.hpp>

namespace groundtruth::fast {

// Only one contender, which certainly hits through one leaf alone: that leaf, and only that, is admissible.
// Else no_leaf.
Face sole_face(const Scene& scene, const Probe& probe, const SearchResult& result);

// What `result` says first of the scene's parts is sure of all of them (search_task.hpp). Requires an empty
// one.
void search(const Scene& scene, const Probe& probe, SearchResult& result);

// Asks the memory that search() will look at for an ask to come closer, as far as it is known without waiting
// for it: each step needs that the ones before it have had time. A range that the grid does not serve has no
// steps.
class Prefetcher {
 public:
  Prefetcher(const Scene& scene, const RangeEnds& ends);

  void fetch_starts() const;
  void fetch_entries() const;
  void fetch_cells();
  void fetch_half_spaces() const;

 private:
  static constexpr std::size_t most_parts = 4;

  const Scene& scene_;
  std::uint64_t here_ = 0;  // the range in it
  std::size_t square_ = 0;  // the first that the range is over
  bool has_square_ = false;
  std::uint32_t parts_[most_parts] = {};
  std::size_t part_count_ = 0;
};

}  // namespace groundtruth::fast
