#pragma once
// Where a segment first meets an expression (SPEC section 3, without faces). Not installed.

#include <algorithm>
#include <optional>

#include <groundtruth/fast/expression.hpp>
#include <groundtruth/fast/segment.hpp>

namespace groundtruth::fast {

template <class Number>
struct Arrival {
  Number lambda;
  // The leaf that is entered there, where it is known that lambda > range.first and that no other leaf of
  // the solid that counts there is entered at the same lambda: then only this one can be admissible.
  std::optional<Leaf> sole_leaf;
};

// The first point of an intersection of half-spaces: entry and exit bounds in one pass.
template <class Number>
std::optional<Arrival<Number>> arrive_at_cell(const HalfSpace* first_leaf, const HalfSpace* end_leaf,
                                              Leaf number, const Segment<Number>& segment,
                                              Range<Number> range) {
  Arrival<Number> arrival{range.first, std::nullopt};
  Number exit = range.last;
  for (const HalfSpace* leaf = first_leaf; leaf != end_leaf; ++leaf, ++number) {
    const Approach<Number> approach = segment.approach(*leaf);
    if (approach.enters()) {
      const Number crossing = approach.crossing();
      if (crossing < arrival.lambda) continue;
      if (crossing > exit) return std::nullopt;
      arrival.sole_leaf = crossing > arrival.lambda ? std::optional(number) : std::nullopt;
      arrival.lambda = crossing;
    } else if (approach.value > 0 && (range.first >= 0 || !approach.leaves())) {
      return std::nullopt;  // out of it at lambda = 0 and never nearer
    } else if (approach.leaves()) {
      exit = std::min(exit, approach.crossing());
      if (exit < arrival.lambda) return std::nullopt;
    }
  }
  return arrival;
}

template <class Number>
class ArrivalSearch {
 public:
  ArrivalSearch(const Expression& expression, const Segment<Number>& segment)
      : expression_(expression), segment_(segment) {}

  // The first point in the range; nothing if there is none.
  std::optional<Arrival<Number>> first(Range<Number> range) const { return first(root(), range); }

 private:
  using Nodes = const Node*;

  Nodes root() const { return expression_.nodes.data(); }

  std::optional<Arrival<Number>> cell(Nodes node, Range<Number> range) const {
    const HalfSpace* leaves = expression_.leaves.data();
    return arrive_at_cell(leaves + node->first_leaf, leaves + node->end_leaf, Leaf{node->first_leaf},
                          segment_, range);
  }

  std::optional<Arrival<Number>> first(Nodes node, Range<Number> range) const {
    switch (node->kind) {
      case NodeKind::nothing:
        return std::nullopt;
      case NodeKind::everything:
        return Arrival<Number>{range.first, std::nullopt};
      case NodeKind::cell:
        return cell(node, range);
      case NodeKind::union_of:
        return first_of_union(node, range);
      case NodeKind::intersection_of:
        break;
    }
    return first_by_steps(node, range);
  }

  std::optional<Arrival<Number>> first_of_union(Nodes node, Range<Number> range) const {
    std::optional<Arrival<Number>> best;
    for (Nodes operand = node + 1; operand != node + node->size; operand += operand->size) {
      const auto arrival = first(operand, range);
      if (!arrival) continue;
      if (best && arrival->lambda == best->lambda)
        best->sole_leaf.reset();
      else
        best = arrival;
      range.last = best->lambda;
    }
    return best;
  }

  // Each step goes to a crossing further on, so there are no more steps than leaves.
  std::optional<Arrival<Number>> first_by_steps(Nodes node, Range<Number> range) const {
    for (;;) {
      const std::optional<Number> next = earliest(node, range);
      if (!next) return std::nullopt;
      if (!(*next > range.first)) return Arrival<Number>{range.first, std::nullopt};
      range.first = *next;
    }
  }

  // A lower bound of the first point in the range: range.first if and only if that lies in the expression.
  // Nothing: the range misses.
  std::optional<Number> earliest(Nodes node, Range<Number> range) const {
    switch (node->kind) {
      case NodeKind::nothing:
        return std::nullopt;
      case NodeKind::everything:
        return range.first;
      case NodeKind::cell: {
        const auto arrival = cell(node, range);
        return arrival ? std::optional(arrival->lambda) : std::nullopt;
      }
      case NodeKind::union_of:
        return earliest_of_union(node, range);
      case NodeKind::intersection_of:
        break;
    }
    return earliest_of_intersection(node, range);
  }

  std::optional<Number> earliest_of_union(Nodes node, Range<Number> range) const {
    std::optional<Number> best;
    for (Nodes operand = node + 1; operand != node + node->size; operand += operand->size) {
      const std::optional<Number> next = earliest(operand, range);
      if (!next) continue;
      if (*next == range.first) return next;
      best = next;
      range.last = *next;
    }
    return best;
  }

  // Operands are asked at range.first, not at the bound so far: only so does "range.first" stay a statement
  // about that one point, and nested intersections cost no nested restarts.
  std::optional<Number> earliest_of_intersection(Nodes node, Range<Number> range) const {
    Number latest = range.first;
    for (Nodes operand = node + 1; operand != node + node->size; operand += operand->size) {
      const std::optional<Number> next = earliest(operand, range);
      if (!next) return std::nullopt;
      latest = std::max(latest, *next);
    }
    return latest;
  }

  const Expression& expression_;
  const Segment<Number>& segment_;
};

}  // namespace groundtruth::fast
