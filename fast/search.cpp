#include <groundtruth/fast/search.hpp>

#include <algorithm>
#include <utility>

#include <groundtruth/fast/box_probe.hpp>
#include <groundtruth/fast/cell_kernels.hpp>

namespace groundtruth::fast {

double SearchResult::lower() const {
  double least = 1;
  for (const Contender& contender : contenders) least = std::min(least, contender.meeting.lower);
  return least;
}

void SearchResult::drop_late_ones() {
  if (contenders.size() < 2) return;
  std::size_t kept = 0;
  for (const Contender& contender : contenders)
    if (contender.meeting.lower <= upper) contenders[kept++] = contender;
  contenders.shrink(kept);
}

void Contenders::grow() {
  auto more = std::make_unique<Contender[]>(2 * capacity_);
  std::copy(begin(), end(), more.get());
  more_ = std::move(more);
  first_ = more_.get();
  capacity_ *= 2;
}

namespace {

Meeting meet_general(const SearchTask& task, Part part) {
  const auto& scene = *static_cast<const Scene*>(task.context);
  SievedExpression sieved;
  sieve(scene.solid(), scene.solid().nodes.data() + scene.parts().node_of(part), task.probe, sieved);
  return meet(sieved);
}

void visit_all_of_hierarchy(const Parts& parts, SearchTask& task) {
  for (const BoxNode& node : parts.hierarchy.nodes)
    for (const std::uint32_t child : node.children) {
      if (child < BoxNode::first_part || child == BoxNode::no_child) continue;
      const Part part = child - BoxNode::first_part;
      parts.kernels->visit_parts(task, &part, &part + 1);
      if (task.result.starts_inside) return;
    }
}

}  // namespace

void search(const Scene& scene, const Probe& probe, SearchResult& result) {
  const Parts& parts = scene.parts();
  const RangeEnds& ends = probe.ends();
  SearchTask task{parts.cells.groups.data(),
                  parts.cells.cells.data(),
                  parts.cells.cells.size(),
                  parts.apart.data(),
                  parts.apart.data() + parts.apart.size(),
                  parts.grid,
                  parts.grid.starts.data(),
                  parts.grid.entries.data(),
                  ends.first.data(),
                  ends.last.data(),
                  probe,
                  result,
                  meet_general,
                  &scene};
  if (parts.kernels->visit_near(task) == Left::hierarchy && !parts.hierarchy.nodes.empty()) {
    if (suit_boxes(probe.greatest_coordinate(), ends.coordinate_error))
      parts.kernels->visit_hierarchy(task, parts.hierarchy.nodes.data(), BoxProbe(ends).way());
    else
      visit_all_of_hierarchy(parts, task);
  }
  result.drop_late_ones();
}

namespace {

// Apart, so that a cell's face need not make room for it.
[[gnu::noinline]] Face sole_face_of_general(const Scene& scene, const Probe& probe,
                                            const Contender& contender) {
  SievedExpression sieved;
  sieve(scene.solid(), scene.solid().nodes.data() + scene.parts().node_of(contender.part), probe, sieved);
  const Leaf leaf = sole_leaf(sieved, contender.meeting);
  return leaf == no_leaf ? Face{} : Face{leaf, scene.solid().leaves[leaf], {}};
}

}  // namespace

Face sole_face(const Scene& scene, const Probe& probe, const SearchResult& result) {
  if (result.contenders.size() != 1) return {};
  const Contender& sole = result.contenders.front();
  if (!sole.meeting.certainly_hits()) return {};
  const PackedCells& cells = scene.parts().cells;
  if (!scene.parts().is_cell(sole.part)) return sole_face_of_general(scene, probe, sole);
  return sole_face(cells, cells.cells[sole.part], sole.meeting);
}

}  // namespace groundtruth::fast
