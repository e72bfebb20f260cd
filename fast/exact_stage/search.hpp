#pragma once
// Phi's lambda over exact numbers of any kind, without a division. Not installed.

#include <optional>

#include <boost/container/small_vector.hpp>
#include <groundtruth/fast/exact_stage/entry.hpp>
#include <groundtruth/fast/exact_stage/surd.hpp>

namespace groundtruth::fast::exact_stage {

__extension__ using MachineInteger = __int128;

inline int sign(const MachineInteger& x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

// The kinds of numbers. `Slope` numbers may be multiplied with each other and with `Value` numbers; Value
// numbers are only added and compared.
struct MachineNumbers {
  using Value = MachineInteger;
  using Slope = MachineInteger;
  static Value value(const Slope& x) { return x; }
  int sign(const Value& x) const { return exact_stage::sign(x); }
};

struct DyadicNumbers {
  using Value = Dyadic;
  using Slope = Dyadic;
  static Value value(const Slope& x) { return x; }
  int sign(const Value& x) const { return x.sign(); }
};

struct SurdNumbers {
  using Value = Surd;
  using Slope = Dyadic;
  static Value value(const Slope& x) { return {x, {}, {}}; }
  Radicands roots;
  int sign(const Value& x) const { return exact_stage::sign(x, roots); }
  int sign(const Slope& x) const { return x.sign(); }
};

// Delta along the segment, times a positive number: value + t slope, where t is 0 at the start of the range.
template <class Numbers>
struct Line {
  typename Numbers::Value value{};
  typename Numbers::Slope slope{};
  int slope_sign = 0;

  bool enters() const { return slope_sign < 0; }
  bool leaves() const { return slope_sign > 0; }
};

// So many of them fit without allocation.
template <class Numbers>
using Lines = boost::container::small_vector<Line<Numbers>, 16384 / sizeof(Line<Numbers>)>;

// A place on the segment is where some line is zero: t = -value / slope. Requires slope != 0.
template <class Numbers>
using Place = const Line<Numbers>*;

// The sign of t_a - t_b, by the determinant of the two lines.
template <class Numbers>
int compare(const Numbers& numbers, Place<Numbers> a, Place<Numbers> b) {
  if (a == b) return 0;
  return numbers.sign(b->value * a->slope - a->value * b->slope) * a->slope_sign * b->slope_sign;
}

// The sign of the line at a place.
template <class Numbers>
int side(const Numbers& numbers, const Line<Numbers>& line, Place<Numbers> place) {
  if (&line == place) return 0;
  return numbers.sign(line.value * place->slope - place->value * line.slope) * place->slope_sign;
}

template <class Numbers>
class Search {
 public:
  using At = Place<Numbers>;

  Search(const Numbers& numbers, const ExpressionView& solid, const Lines<Numbers>& lines)
      : numbers_(numbers), solid_(solid), lines_(lines) {}

  // The first place in [first, last] in the solid. Each step of the loop goes to a crossing further on.
  std::optional<At> first_place(At first, At last) const {
    if (solid_.nodes.empty()) return std::nullopt;
    for (;;) {
      const auto next = earliest(solid_.nodes.data(), first, last);
      if (!next || *next == first || compare(numbers_, *next, first) == 0) return next;
      first = *next;
    }
  }

  bool contains(const Node* node, At place) const {
    const auto some_operand_is = [&](bool member) {
      for (const Node* operand = node + 1; operand != node + node->size; operand += operand->size)
        if (contains(operand, place) == member) return true;
      return false;
    };
    switch (node->kind) {
      case NodeKind::nothing:
        return false;
      case NodeKind::everything:
        return true;
      case NodeKind::cell:
        for (std::size_t leaf = node->first_leaf; leaf != node->end_leaf; ++leaf)
          if (side(numbers_, lines_[leaf], place) > 0) return false;
        return true;
      case NodeKind::union_of:
        return some_operand_is(true);
      case NodeKind::intersection_of:
        break;
    }
    return !some_operand_is(false);
  }

 private:
  // A lower bound of the node's first place in [first, last], equal to `first` iff that lies in the node;
  // nothing: the range misses the node.
  std::optional<At> earliest(const Node* node, At first, At last) const {
    switch (node->kind) {
      case NodeKind::nothing:
        return std::nullopt;
      case NodeKind::everything:
        return first;
      case NodeKind::cell:
        return earliest_in_cell(*node, first, last);
      case NodeKind::union_of:
        return earliest_in_union(node, first, last);
      case NodeKind::intersection_of:
        break;
    }
    At latest = first;
    for (const Node* operand = node + 1; operand != node + node->size; operand += operand->size) {
      const auto next = earliest(operand, first, last);
      if (!next) return std::nullopt;
      if (compare(numbers_, *next, latest) > 0) latest = *next;
    }
    return latest;
  }

  std::optional<At> earliest_in_union(const Node* node, At first, At last) const {
    std::optional<At> best;
    for (const Node* operand = node + 1; operand != node + node->size; operand += operand->size) {
      const auto next = earliest(operand, first, last);
      if (!next) continue;
      if (compare(numbers_, *next, first) == 0) return next;
      best = last = *next;
    }
    return best;
  }

  // Bounds of entry and exit in one pass: exact, so "lower bound" is the first place itself.
  std::optional<At> earliest_in_cell(const Node& cell, At first, At last) const {
    At entry = first, exit = last;
    for (std::size_t leaf = cell.first_leaf; leaf != cell.end_leaf; ++leaf) {
      const Line<Numbers>& line = lines_[leaf];
      if (line.slope_sign == 0) {
        if (numbers_.sign(line.value) > 0) return std::nullopt;
      } else if (line.enters()) {
        if (compare<Numbers>(numbers_, &line, entry) <= 0) continue;
        entry = &line;
        if (compare(numbers_, entry, exit) > 0) return std::nullopt;
      } else if (compare<Numbers>(numbers_, &line, exit) < 0) {
        exit = &line;
        if (compare(numbers_, entry, exit) > 0) return std::nullopt;
      }
    }
    return entry;
  }

  const Numbers& numbers_;
  const ExpressionView& solid_;
  const Lines<Numbers>& lines_;
};

}  // namespace groundtruth::fast::exact_stage
