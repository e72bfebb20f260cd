#pragma once
// The loops of a search over lanes of any kind: parts one by one, those over squares, those in a hierarchy.
// Not installed.
//
// As cell_kernels_body.hpp: nothing here may be shared between sets of instructions.

#include <groundtruth/fast/box_search_body.hpp>
#include <groundtruth/fast/cell.hpp>
#include <groundtruth/fast/cell_kernels_body.hpp>
#include <groundtruth/fast/grid_probe.hpp>
#include <groundtruth/fast/search_task.hpp>

namespace groundtruth::fast {

template <class Lanes, class FloatLanes>
class PartSearch {
 public:
  explicit PartSearch(SearchTask& task) : task_(task) {}

  // False: the range certainly starts inside, and nothing else matters.
  [[gnu::always_inline]] inline bool visit(Part part) {
    SearchResult& result = task_.result;
    const Meeting meeting =
        part < task_.cell_count ? meet(task_.cells[part]) : task_.meet_general(task_, part);
    if (meeting.lower > result.upper) return true;
    if (meeting.upper < 0) {
      result.starts_inside = true;
      return false;
    }
    if (meeting.upper < result.upper) result.upper = meeting.upper;
    result.contenders.push_back({part, meeting});
    return true;
  }

  // The parts apart, and those in squares if the range is over few.
  [[gnu::always_inline]] inline Left visit_near() {
    for (const Part* part = task_.apart; part != task_.apart_end; ++part)
      if (!visit(*part)) return Left::nothing;
    if (task_.grid.rows == 0) return Left::hierarchy;
    const double coordinate_error = task_.probe.ends().coordinate_error;
    if (!suit_boxes(task_.probe.greatest_coordinate(), coordinate_error)) return Left::hierarchy;
    const GridProbe<Lanes> near(task_.grid, task_.first, task_.last, coordinate_error);
    const Squares squares = near.squares();
    if (!is_served(squares)) return Left::hierarchy;
    visit_squares(near, squares);
    return Left::nothing;
  }

  // Nearest boxes first.
  [[gnu::always_inline]] inline void visit_hierarchy(const BoxNode* nodes, const BoxWay& way) {
    const BoxMeeter<FloatLanes> boxes(way);
    OpenChildren<FloatLanes> open;
    std::uint32_t child = 0;
    do {
      if (child >= BoxNode::first_part) {
        if (!visit(child - BoxNode::first_part)) return;
        continue;
      }
      const BoxNode& node = nodes[child];
      const auto upper = static_cast<float>(task_.result.upper * (1 + 0x1p-20));
      // Inlined always: what only fetches has no effect that a compiler would call it for.
      const auto fetch_child = [&](std::uint32_t next) __attribute__((always_inline)) { fetch(nodes, next); };
      open.push(boxes.meet(node, upper), node.children, fetch_child);
    } while (open.pop(task_.result.upper, child));
  }

 private:
  [[gnu::always_inline]] inline void visit_squares(const GridProbe<Lanes>& near, const Squares& squares) {
    const bool may_repeat = squares.count() > 1;
    for (std::uint32_t row = squares.first_row; row <= squares.last_row; ++row)
      for (std::uint32_t column = squares.first_column; column <= squares.last_column; ++column) {
        const std::uint32_t* const starts = task_.starts + std::size_t{row} * task_.grid.columns + column;
        const GridEntry *first = task_.entries + starts[0], *const end = task_.entries + starts[1];
        if (first == end) continue;
        const std::uint64_t here = near.in_square(column, row);
        for (; first != end; first += few_entries < end - first ? few_entries : end - first)
          if (!visit_few(here, first, few_entries < end - first ? first + few_entries : end, may_repeat))
            return;
      }
  }

  // At most few_entries. First those that are reached are gathered: which ones are nobody can foretell.
  [[gnu::always_inline]] inline bool visit_few(std::uint64_t here, const GridEntry* entry,
                                               const GridEntry* end, bool may_repeat) {
    Part reached[few_entries];
    std::size_t count = 0;
    for (; entry != end; ++entry) {
      reached[count] = entry->part;
      count += Stretches::reach(here, entry->places);
    }
    for (std::size_t i = 0; i < count; ++i) {
      // Other squares may name the same parts.
      if (may_repeat && task_.result.contenders.has(reached[i])) continue;
      if (!visit(reached[i])) return false;
    }
    return true;
  }

  // Asks the memory for what will be looked at, so that one wait serves all children of a node.
  [[gnu::always_inline]] inline void fetch(const BoxNode* nodes, std::uint32_t child) const {
    if (child >= BoxNode::first_part) {
      __builtin_prefetch(task_.cells + (child - BoxNode::first_part));
      return;
    }
    const char* const bytes = reinterpret_cast<const char*>(nodes + child);
    for (std::size_t at = 0; at < sizeof(BoxNode); at += 64) __builtin_prefetch(bytes + at);
  }

  [[gnu::always_inline]] inline Meeting meet(const Cell& cell) const {
    const double error = task_.probe.error_bound(double{cell.normal_size}, double{cell.offset_size});
    if (!(error < greatest_usable_error)) return {0, 2, no_place};
    const HalfSpaces4* const first = task_.groups + cell.first_group;
    if (cell.leaf_count == 1)
      return meet_half_space(*first, task_.first, task_.last, error, task_.result.upper);
    // Not kept: what is loaded each time costs less than what must be saved.
    const EndLanes<Lanes> ends(task_.first, task_.last);
    return meet_groups<Lanes>(first, first + (cell.leaf_count + 3) / 4, ends, error, task_.result.upper);
  }

  static constexpr std::ptrdiff_t few_entries = 16;

  SearchTask& task_;
};

template <class Lanes, class FloatLanes>
void visit_parts(SearchTask& task, const Part* first, const Part* end) {
  PartSearch<Lanes, FloatLanes> search(task);
  for (; first != end; ++first)
    if (!search.visit(*first)) return;
}

template <class Lanes, class FloatLanes>
Left visit_near(SearchTask& task) {
  return PartSearch<Lanes, FloatLanes>(task).visit_near();
}

template <class Lanes, class FloatLanes>
void visit_hierarchy(SearchTask& task, const BoxNode* nodes, const BoxWay& way) {
  PartSearch<Lanes, FloatLanes>(task).visit_hierarchy(nodes, way);
}

template <class Lanes, class FloatLanes, class Products>
constexpr CellKernels kernels_of{visit_near<Lanes, FloatLanes>, visit_parts<Lanes, FloatLanes>,
                                 visit_hierarchy<Lanes, FloatLanes>, meet_eight_boxes<FloatLanes>,
                                 rounded_crossing_of<Products>};

}  // namespace groundtruth::fast
