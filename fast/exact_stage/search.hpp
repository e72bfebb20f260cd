#pragma once
// Phi's lambda over exact numbers of any kind. Not installed.

#include <optional>

#include <groundtruth/fast/evaluate.hpp>
#include <groundtruth/fast/exact_stage/entry.hpp>
#include <groundtruth/fast/exact_stage/lines.hpp>
#include <groundtruth/fast/first_place.hpp>

namespace groundtruth::fast::exact_stage {

// Cells of half-spaces that go along `lines`.
template <class Numbers>
class CellsAlongLines {
 public:
  using Place = exact_stage::Place<Numbers>;

  CellsAlongLines(const Numbers& numbers, const Lines<Numbers>& lines) : numbers_(numbers), lines_(lines) {}

  int compare(Place a, Place b) const { return exact_stage::compare(numbers_, a, b); }

  // Bounds of entry and exit in one pass: exact, so "lower bound" is the first place itself.
  std::optional<Place> first_in(const Node& cell, Place first, Place last) const {
    Place entry = first, exit = last;
    for (std::size_t leaf = cell.first_leaf; leaf != cell.end_leaf; ++leaf) {
      const Line<Numbers>& line = lines_[leaf];
      if (line.slope_sign == 0) {
        if (numbers_.sign(line.value) > 0) return std::nullopt;
        continue;
      }
      Place& bound = line.enters() ? entry : exit;
      if (compare(&line, bound) * line.slope_sign >= 0) continue;
      bound = &line;
      if (compare(entry, exit) > 0) return std::nullopt;
    }
    return entry;
  }

 private:
  const Numbers& numbers_;
  const Lines<Numbers>& lines_;
};

// Membership of the point at a place.
template <class Numbers>
class MembershipAt {
 public:
  using Value = bool;

  MembershipAt(const Numbers& numbers, const Lines<Numbers>& lines, Place<Numbers> place)
      : numbers_(numbers), lines_(lines), place_(place) {}

  static bool of_none(Operator op) { return op == Operator::intersection_of; }
  bool of_leaf(std::size_t leaf) const { return side(numbers_, lines_[leaf], place_) <= 0; }
  static void join(Operator, bool& all, bool one) { all = one; }
  static bool is_settled(Operator op, bool all) { return all != of_none(op); }

 private:
  const Numbers& numbers_;
  const Lines<Numbers>& lines_;
  const Place<Numbers> place_;
};

// The first place in [first, last] in a solid.
template <class Numbers>
std::optional<Place<Numbers>> first_place(const Numbers& numbers, const ExpressionView& solid,
                                          const Lines<Numbers>& lines, Place<Numbers> first,
                                          Place<Numbers> last) {
  if (solid.nodes.empty()) return std::nullopt;
  const CellsAlongLines<Numbers> cells(numbers, lines);
  return FirstPlace(cells).of(solid.nodes.data(), first, last);
}

template <class Numbers>
bool contains(const Numbers& numbers, const ExpressionView& region, const Lines<Numbers>& lines,
              Place<Numbers> place) {
  return !region.nodes.empty() && evaluate(MembershipAt<Numbers>(numbers, lines, place), region.nodes.data());
}

}  // namespace groundtruth::fast::exact_stage
