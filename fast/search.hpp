#pragma once
// Where a range first meets the parts of a solid, as far as doubles can tell. Not installed.

#include <groundtruth/fast/cell_kernels.hpp>
#include <groundtruth/fast/grid_probe.hpp>
#include <groundtruth/fast/range_ends.hpp>
#include <groundtruth/fast/scene.hpp>
#include <groundtruth/fast/search_task.hpp>
#include <groundtruth/fast/sieved.hpp>

namespace groundtruth::fast {

// What few asks need; what every ask goes through stands below, to be inlined.
// Of a part that is no cell.
Meeting meet_general(const SearchTask& task, Part part);
Face sole_face_of_general(const Scene& scene, const Probe& probe, const Contender& contender);
// Adds what the range may meet of the hierarchy.
void search_hierarchy(const Parts& parts, SearchTask& task);

// The only contender, if it certainly hits; else null.
inline const Contender* sole_hit(const SearchResult& result) {
  if (result.contenders.size() != 1) return nullptr;
  const Contender& sole = result.contenders.front();
  return sole.meeting.certainly_hits() ? &sole : nullptr;
}

// A sole hit through one leaf alone: that leaf, and only that, is admissible. Else no_leaf.
inline Face sole_face(const Scene& scene, const Probe& probe, const SearchResult& result) {
  const Contender* const sole = sole_hit(result);
  if (sole == nullptr) return {};
  const PackedCells& cells = scene.parts().cells;
  if (!scene.parts().is_cell(sole->part)) return sole_face_of_general(scene, probe, *sole);
  return sole_face(cells, cells.cells[sole->part], sole->meeting);
}
// The same where all parts are these cells.
inline Face sole_face(const PackedCells& cells, const SearchResult& result) {
  const Contender* const sole = sole_hit(result);
  return sole == nullptr ? Face{} : sole_face(cells, cells.cells[sole->part], sole->meeting);
}

// Over cells of the scene's, or what a box leaves of them; no part is apart.
inline SearchTask search_task(const Scene& scene, const PackedCells& cells, const Probe& probe,
                              SearchResult& result) {
  const Grid& grid = scene.parts().grid;
  const RangeEnds& ends = probe.ends();
  return {cells.groups.data(),
          cells.cells.data(),
          cells.cells.size(),
          nullptr,
          nullptr,
          grid,
          grid.starts.data(),
          grid.entries.data(),
          ends.first.data(),
          ends.last.data(),
          probe,
          result,
          meet_general,
          &scene};
}

// What `result` says first of the scene's parts is sure of all of them (search_task.hpp). Requires an empty
// one.
inline void search(const Scene& scene, const Probe& probe, SearchResult& result) {
  const Parts& parts = scene.parts();
  SearchTask task = search_task(scene, parts.cells, probe, result);
  task.apart = parts.apart.data();
  task.apart_end = task.apart + parts.apart.size();
  if (parts.kernels->visit_near(task) == Left::hierarchy && !parts.hierarchy.nodes.empty())
    search_hierarchy(parts, task);
  if (result.contenders.size() > 1) result.drop_late_ones();
}

}  // namespace groundtruth::fast
