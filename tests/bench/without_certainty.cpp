// What filter and rounding cost: fast's index and cells, searched in the same order without either.

#include <algorithm>
#include <bit>

#include <boost/container/small_vector.hpp>
#include <groundtruth/fast/box_probe.hpp>
#include <groundtruth/fast/grid_probe.hpp>
#include <groundtruth/fast/lanes.hpp>
#include <groundtruth/tests/bench/peer.hpp>

namespace groundtruth::bench {

namespace {

using fast::BoxNode;
using fast::Lanes;

class PlainSearch {
 public:
  PlainSearch(const fast::Parts& parts, const EntryAsk& ask)
      : parts_(parts), from_(ask.from), to_(ask.to), ends_{ask.from, ask.to, 0} {}

  // 2: a miss.
  double first_position() {
    for (const fast::Part part : parts_.apart) visit(part);
    if (parts_.hierarchy.nodes.empty()) return nearest_;
    if (!visit_squares()) visit_hierarchy();
    return nearest_;
  }

 private:
  void visit(fast::Part part) {
    const fast::Cell& cell = parts_.cells.cells[part];
    const Lanes zero = Lanes::all(0), one = Lanes::all(1), before = Lanes::all(-1), after = Lanes::all(2);
    Lanes enter = zero, exit = after;
    Lanes::Choice is_outside{};
    for (std::uint32_t i = cell.first_group; i != cell.end_group(); ++i) {
      const fast::HalfSpaces4& group = parts_.cells.groups[i];
      const Lanes x = Lanes::load(group.normal_x), y = Lanes::load(group.normal_y),
                  z = Lanes::load(group.normal_z), offset = Lanes::load(group.offset);
      const Lanes a = x * Lanes::all(from_[0]) + y * Lanes::all(from_[1]) + z * Lanes::all(from_[2]) - offset;
      const Lanes b = x * Lanes::all(to_[0]) + y * Lanes::all(to_[1]) + z * Lanes::all(to_[2]) - offset;
      is_outside = is_outside | ((a > zero) & (b > zero));
      const Lanes w = a - b, crossing = a / choose((w > zero) | (w < zero), w, one);
      enter = greater(choose(w > zero, crossing, before), enter);
      exit = lesser(choose(w < zero, crossing, after), exit);
    }
    if (is_outside.bits() != 0) return;
    const double first = enter.greatest();
    if (first <= 1 && first <= exit.least()) nearest_ = std::min(nearest_, first);
  }

  bool visit_squares() {
    const fast::Grid& grid = parts_.grid;
    if (grid.rows == 0) return false;
    const fast::GridProbe<Lanes> near(grid, from_.data(), to_.data(), 0);
    const fast::Squares squares = near.squares();
    if (!fast::is_served(squares)) return false;
    for (std::uint32_t row = squares.first_row; row <= squares.last_row; ++row)
      for (std::uint32_t column = squares.first_column; column <= squares.last_column; ++column) {
        const std::size_t square = std::size_t{row} * grid.columns + column;
        const std::uint64_t here = near.in_square(column, row);
        for (std::uint32_t i = grid.starts[square]; i != grid.starts[square + 1]; ++i)
          if (fast::Stretches::reach(here, grid.entries[i].places) != 0) visit(grid.entries[i].part);
      }
    return true;
  }

  struct Open {
    float nearest;
    std::uint32_t child;
  };

  void visit_hierarchy() {
    const fast::BoxProbe box_probe(ends_);
    boost::container::small_vector<Open, 128> open{{0, 0}};
    while (!open.empty()) {
      const Open top = open.back();
      open.pop_back();
      if (double{top.nearest} > nearest_) continue;
      if (top.child >= BoxNode::first_part) {
        visit(top.child - BoxNode::first_part);
        continue;
      }
      const BoxNode& node = parts_.hierarchy.nodes[top.child];
      float nearest[BoxNode::width];
      unsigned met = box_probe.meet(*parts_.kernels, node, std::min(nearest_, 1.0), nearest);
      const std::size_t below = open.size();
      for (; met != 0; met &= met - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(met));
        open.push_back({nearest[i], node.children[i]});
        for (std::size_t at = open.size() - 1; at > below && open[at - 1].nearest < open[at].nearest; --at)
          std::swap(open[at - 1], open[at]);
      }
    }
  }

  const fast::Parts& parts_;
  const Vector& from_;
  const Vector& to_;
  const fast::RangeEnds ends_;
  double nearest_ = 2;
};

}  // namespace

Peer without_certainty(std::shared_ptr<const fast::Scene> scene) {
  return {"without certainty", [=](std::span<const EntryAsk> asks) {
            std::size_t hits = 0;
            for (const EntryAsk& ask : asks) hits += PlainSearch(scene->parts(), ask).first_position() <= 1;
            return hits;
          }};
}

}  // namespace groundtruth::bench
