#include <groundtruth/fast/undecided.hpp>

#include <algorithm>
#include <cmath>

namespace groundtruth::fast {

std::uint32_t OpenSolid::add_leaf(Leaf number, const HalfSpace& half_space) {
  leaves_.push_back(half_space);
  numbers_.push_back(number);
  return static_cast<std::uint32_t>(leaves_.size());
}

void OpenSolid::assemble(const Contender* first, const Contender* end, double upper) {
  nodes_.clear();
  leaves_.clear();
  numbers_.clear();
  nodes_.push_back({.kind = NodeKind::union_of});
  for (const Contender* contender = first; contender != end; ++contender) {
    if (scene_.parts().is_cell(contender->part))
      add_cell(*contender, upper);
    else
      add_general(*contender);
  }
  nodes_.front().size = static_cast<std::uint32_t>(nodes_.size());
}

// A leaf that the range has certainly entered before contender.meeting.lower holds from there on; before it
// some leaf that is kept does not. One that it certainly leaves behind `upper` holds until there.
void OpenSolid::add_cell(const Contender& contender, double upper) {
  const auto first = static_cast<std::uint32_t>(leaves_.size());
  std::uint32_t end = first;
  const PackedCells& cells = scene_.parts().cells;
  const Cell& cell = cells.cells[contender.part];
  OpenLeaves open;
  add_open_leaves(cells, cell, probe_, open);
  for (const OpenLeaf& leaf : open) {
    const bool holds = (leaf.turn == Turn::enters && leaf.upper < contender.meeting.lower) ||
                       (leaf.turn == Turn::leaves && leaf.lower > upper);
    if (!holds) end = add_leaf(cells.leaf_at(cell, leaf.leaf), cells.half_space_at(cell, leaf.leaf));
  }
  if (first == end)
    nodes_.push_back({.kind = NodeKind::everything});
  else
    nodes_.push_back({NodeKind::cell, 1, first, end});
}

void OpenSolid::add_general(const Contender& contender) {
  SievedExpression sieved;
  const Expression& solid = scene_.solid();
  sieve(solid, solid.nodes.data() + scene_.parts().node_of(contender.part), probe_, sieved);
  const auto first = static_cast<std::uint32_t>(leaves_.size());
  for (Node node : sieved.nodes) {
    node.first_leaf += first;
    node.end_leaf += first;
    nodes_.push_back(node);
  }
  for (const OpenLeaf& leaf : sieved.leaves) add_leaf(leaf.leaf, solid.leaves[leaf.leaf]);
}

RoundedLambda OpenSolid::lambda(const exact_stage::FirstPoint& point, const EntryAsk& ask) const {
  if (!point.crossed) return {ask.lambda_first + 0.0, Stage::none};
  return correctly_rounded_crossing(*scene_.parts().kernels, leaf(*point.crossed), ask);
}

namespace {

// An upper bound of s at a correctly rounded lambda.
double position_above(double lambda, const EntryAsk& ask) {
  if (!(ask.lambda_first < ask.lambda_last)) return 1;
  const double above = lambda + 0x2p-53 * std::abs(lambda) + 0x1p-1070;
  const double s = (above - ask.lambda_first) / (ask.lambda_last - ask.lambda_first) * (1 + 0x8p-53);
  return s >= 0 && s <= 1 ? s : 1;
}

// More contenders than this are looked through one by one first.
constexpr std::size_t few = 8;

}  // namespace

std::optional<ExactEntry> decide(const Scene& scene, const Probe& probe, const EntryAsk& ask,
                                 SearchResult& result) {
  OpenSolid open(scene, probe);
  Contenders& contenders = result.contenders;
  if (contenders.size() > few)
    std::sort(contenders.begin(), contenders.end(),
              [](const Contender& a, const Contender& b) { return a.meeting.lower < b.meeting.lower; });
  while (contenders.size() > few) {
    // The first ones alone: a hit there makes many of the others late, a miss makes these superfluous.
    open.assemble(contenders.data(), contenders.data() + few, result.upper);
    const auto point = exact_stage::first_point(open.view(), ask);
    if (!point) {
      std::move(contenders.begin() + few, contenders.end(), contenders.begin());
      contenders.shrink(contenders.size() - few);
      continue;
    }
    result.upper = std::min(result.upper, position_above(open.lambda(*point, ask).value, ask));
    result.drop_late_ones();
    break;
  }
  open.assemble(contenders.data(), contenders.data() + contenders.size(), result.upper);
  const auto point = exact_stage::first_point(open.view(), ask);
  if (!point) return std::nullopt;
  ExactEntry entry{open.lambda(*point, ask), no_leaf, {}, std::nullopt};
  if (point->leaf) {
    entry.leaf = open.number(*point->leaf);
    entry.half_space = open.leaf(*point->leaf);
  }
  if (point->crossed) entry.crossed = open.leaf(*point->crossed);
  return entry;
}

}  // namespace groundtruth::fast
