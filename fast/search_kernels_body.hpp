#pragma once
// The loops of a search over lanes of any kind: parts one by one, those over a square, those in a hierarchy.
// Not installed.
//
// As cell_kernels_body.hpp: nothing here may be shared between sets of instructions.

#include <groundtruth/fast/box_way.hpp>
#include <groundtruth/fast/cell.hpp>
#include <groundtruth/fast/cell_kernels_body.hpp>
#include <groundtruth/fast/grid_probe.hpp>
#include <groundtruth/fast/search_task.hpp>

namespace groundtruth::fast {

// Lemma box-slabs (box_probe.hpp).
template <class FloatLanes>
class BoxMeeter {
 public:
  explicit BoxMeeter(const BoxWay& way) {
    for (int axis = 0; axis < 3; ++axis) {
      Axis& at = axes_[axis];
      at.near_origin = FloatLanes::all(way.near_origin[axis]);
      at.far_origin = FloatLanes::all(way.far_origin[axis]);
      at.inverse = FloatLanes::all(way.inverse[axis]);
      at.stretched = FloatLanes::all(way.inverse[axis] * (1 + 0x1p-20F));
      at.near_sides = way.is_ascending[axis] ? &BoxNode::low : &BoxNode::high;
      at.far_sides = way.is_ascending[axis] ? &BoxNode::high : &BoxNode::low;
    }
  }

  [[gnu::always_inline]] inline unsigned meet(const BoxNode& node, float upper, float* nearest) const {
    FloatLanes near = FloatLanes::all(0), far = FloatLanes::all(upper);
    for (int axis = 0; axis < 3; ++axis) {
      const Axis& at = axes_[axis];
      const FloatLanes near_side = FloatLanes::load((node.*at.near_sides)[axis]);
      const FloatLanes far_side = FloatLanes::load((node.*at.far_sides)[axis]);
      near = greater((near_side - at.near_origin) * at.inverse, near);
      far = lesser((far_side - at.far_origin) * at.stretched, far);
    }
    near.store(nearest);
    return (near <= far).bits();
  }

 private:
  using Sides = float (BoxNode::*)[3][BoxNode::width];
  struct Axis {
    FloatLanes near_origin, far_origin, inverse, stretched;
    Sides near_sides, far_sides;
  };

  Axis axes_[3];
};

template <class FloatLanes>
unsigned meet_eight_boxes(const BoxNode& node, const BoxWay& way, float upper, float* nearest) {
  return BoxMeeter<FloatLanes>(way).meet(node, upper, nearest);
}

// What is to be looked at, nearest last: the bits of a float >= 0 above the number of a child, in the order
// of the floats.
template <class FloatLanes>
class OpenChildren {
 public:
  [[gnu::always_inline]] inline void push(const float* nearest, const std::uint32_t* children, unsigned met) {
    std::uint64_t* const below = end_;
    for (; met != 0; met &= met - 1) {
      const int child = __builtin_ctz(met);
      std::uint32_t bits;
      __builtin_memcpy(&bits, nearest + child, sizeof bits);
      const std::uint64_t one = std::uint64_t{bits} << 32 | children[child];
      std::uint64_t* at = end_++;
      for (; at != below && at[-1] < one; --at) *at = at[-1];
      *at = one;
    }
  }
  // The next one's number, if there is one that may be met no later than `upper`.
  [[gnu::always_inline]] inline bool pop(double upper, std::uint32_t& child) {
    while (end_ != open_) {
      const std::uint64_t one = *--end_;
      const auto bits = static_cast<std::uint32_t>(one >> 32);
      float nearest;
      __builtin_memcpy(&nearest, &bits, sizeof nearest);
      child = static_cast<std::uint32_t>(one);
      if (double{nearest} <= upper) return true;
    }
    return false;
  }

 private:
  // Each level leaves all but one child of a node.
  static constexpr std::size_t most = (BoxNode::width - 1) * (BoxNode::most_depth + 1) + 1;

  std::uint64_t open_[most];
  std::uint64_t* end_ = open_;
};

template <class Lanes, class FloatLanes>
class PartSearch {
 public:
  explicit PartSearch(SearchTask& task) : task_(task), ends_(task.first, task.last) {}

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

  [[gnu::always_inline]] inline void visit_square(const SquareEntries& square, const SquareProbe& here) {
    for (const GridEntry* entry = square.first; entry != square.end; ++entry) {
      if (!here.reaches(*entry)) continue;
      if (square.may_repeat && task_.result.contenders.has(entry->part)) continue;
      if (!visit(entry->part)) return;
    }
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
      float nearest[BoxNode::width];
      const auto upper = static_cast<float>(task_.result.upper * (1 + 0x1p-20));
      const unsigned met = boxes.meet(node, upper, nearest);
      fetch(nodes, node.children, met);
      open.push(nearest, node.children, met);
    } while (open.pop(task_.result.upper, child));
  }

 private:
  // Asks the memory for what will be looked at, so that one wait serves them all.
  [[gnu::always_inline]] inline void fetch(const BoxNode* nodes, const std::uint32_t* children,
                                           unsigned met) const {
    for (; met != 0; met &= met - 1) {
      const std::uint32_t child = children[__builtin_ctz(met)];
      if (child >= BoxNode::first_part) {
        __builtin_prefetch(task_.cells + (child - BoxNode::first_part));
        continue;
      }
      const char* const bytes = reinterpret_cast<const char*>(nodes + child);
      for (std::size_t at = 0; at < sizeof(BoxNode); at += 64) __builtin_prefetch(bytes + at);
    }
  }

  [[gnu::always_inline]] inline Meeting meet(const Cell& cell) const {
    const double error = task_.probe.error_bound(double{cell.normal_size}, double{cell.offset_size});
    if (!(error < greatest_usable_error)) return {0, 2, no_place};
    const HalfSpaces4* const first = task_.groups + cell.first_group;
    return meet_groups<Lanes>(first, first + (cell.leaf_count + 3) / 4, ends_, error, task_.result.upper);
  }

  SearchTask& task_;
  const EndLanes<Lanes> ends_;
};

template <class Lanes, class FloatLanes>
void visit_parts(SearchTask& task, const Part* first, const Part* end) {
  PartSearch<Lanes, FloatLanes> search(task);
  for (; first != end; ++first)
    if (!search.visit(*first)) return;
}

template <class Lanes, class FloatLanes>
void visit_square(SearchTask& task, const SquareEntries& square, const SquareProbe& here) {
  PartSearch<Lanes, FloatLanes>(task).visit_square(square, here);
}

template <class Lanes, class FloatLanes>
void visit_hierarchy(SearchTask& task, const BoxNode* nodes, const BoxWay& way) {
  PartSearch<Lanes, FloatLanes>(task).visit_hierarchy(nodes, way);
}

template <class Lanes, class FloatLanes, class Products>
constexpr CellKernels kernels_of{visit_parts<Lanes, FloatLanes>, visit_square<Lanes, FloatLanes>,
                                 visit_hierarchy<Lanes, FloatLanes>, meet_eight_boxes<FloatLanes>,
                                 rounded_crossing_of<Products>};

}  // namespace groundtruth::fast
