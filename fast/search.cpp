#include <groundtruth/fast/search.hpp>

#include <algorithm>
#include <utility>

#include <groundtruth/fast/box_probe.hpp>
#include <groundtruth/fast/cell_kernels.hpp>
#include <groundtruth/fast/grid_probe.hpp>

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

// Only a range over few squares is looked up in them: false if it is longer, or there are none.
bool visit_squares(const Parts& parts, SearchTask& task) {
  const Grid& grid = parts.grid;
  if (grid.rows == 0) return false;
  const GridProbe near(grid, task.probe.ends());
  const Squares squares = near.squares();
  if (!is_served(grid, squares)) return false;
  const bool may_repeat = squares.count() > 1;
  for (std::uint32_t row = squares.first_row; row <= squares.last_row; ++row)
    for (std::uint32_t column = squares.first_column; column <= squares.last_column; ++column) {
      const std::uint32_t* const starts = grid.starts.data() + std::size_t{row} * grid.columns + column;
      if (starts[0] == starts[1]) continue;
      const GridEntry* const entries = grid.entries.data();
      parts.kernels->visit_square(task, {entries + starts[0], entries + starts[1], may_repeat},
                                  near.in_square(column, row));
      if (task.result.starts_inside) return true;
    }
  return true;
}

void visit_indexed(const Parts& parts, SearchTask& task) {
  const RangeEnds& ends = task.probe.ends();
  if (!(task.probe.greatest_coordinate() < greatest_box_coordinate && ends.coordinate_error < 1))
    visit_all_of_hierarchy(parts, task);
  else if (!visit_squares(parts, task))
    parts.kernels->visit_hierarchy(task, parts.hierarchy.nodes.data(), BoxProbe(ends).way());
}

}  // namespace

void search(const Scene& scene, const Probe& probe, SearchResult& result) {
  const Parts& parts = scene.parts();
  const RangeEnds& ends = probe.ends();
  SearchTask task{parts.cells.groups.data(),
                  parts.cells.cells.data(),
                  parts.cells.cells.size(),
                  ends.first.data(),
                  ends.last.data(),
                  probe,
                  result,
                  meet_general,
                  &scene};
  if (!parts.apart.empty())
    parts.kernels->visit_parts(task, parts.apart.data(), parts.apart.data() + parts.apart.size());
  if (!parts.hierarchy.nodes.empty() && !result.starts_inside) visit_indexed(parts, task);
  result.drop_late_ones();
}

Face sole_face(const Scene& scene, const Probe& probe, const SearchResult& result) {
  if (result.contenders.size() != 1) return {};
  const auto& [part, meeting] = result.contenders.front();
  if (!meeting.certainly_hits()) return {};
  const Parts& parts = scene.parts();
  if (parts.is_cell(part)) return sole_face(parts.cells, parts.cells.cells[part], meeting);
  SievedExpression sieved;
  sieve(scene.solid(), scene.solid().nodes.data() + parts.node_of(part), probe, sieved);
  const Leaf leaf = sole_leaf(sieved, meeting);
  return leaf == no_leaf ? Face{} : Face{leaf, scene.solid().leaves[leaf], {}};
}

}  // namespace groundtruth::fast
