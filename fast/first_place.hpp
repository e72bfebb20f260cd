#pragma once
// Phi's lambda (SPEC section 3), where numbers are of any kind. Not installed.

#include <optional>

#include <groundtruth/fast/simplify.hpp>

namespace groundtruth::fast {

// Cells: a `Place`; `compare(a, b)`, the sign of a - b; `first_in(cell, first, last)`, a lower bound of the
// first place in [first, last] in a cell, equal to `first` iff that lies in it; nothing: none does.
template <class Cells>
class FirstPlace {
 public:
  using Place = typename Cells::Place;

  explicit FirstPlace(const Cells& cells) : cells_(cells) {}

  // The first place in [first, last] in the expression. Each round goes to a place further on.
  std::optional<Place> of(const Node* node, Place first, Place last) const {
    for (;;) {
      const auto next = earliest(node, first, last);
      if (!next || cells_.compare(*next, first) <= 0) return next;
      first = *next;
    }
  }

 private:
  // What `first_in` is, of any node.
  std::optional<Place> earliest(const Node* node, Place first, Place last) const {
    if (node->kind == NodeKind::cell) return cells_.first_in(*node, first, last);
    if (is_union(*node)) return earliest_in_union(node, first, last);
    Place latest = first;
    for (const Node* operand = node + 1; operand != node + node->size; operand += operand->size) {
      const auto next = earliest(operand, first, last);
      if (!next) return std::nullopt;
      if (cells_.compare(*next, latest) > 0) latest = *next;
    }
    return latest;
  }

  std::optional<Place> earliest_in_union(const Node* node, Place first, Place last) const {
    std::optional<Place> best;
    for (const Node* operand = node + 1; operand != node + node->size; operand += operand->size) {
      const auto next = earliest(operand, first, last);
      if (!next) continue;
      if (cells_.compare(*next, first) <= 0) return next;
      best = last = *next;
    }
    return best;
  }

  const Cells& cells_;
};

}  // namespace groundtruth::fast
