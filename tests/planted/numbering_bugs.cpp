// Mistakes in numbering the leaves.

#include <algorithm>

#include "ways.hpp"

namespace groundtruth::planted {
namespace {

// How many half-spaces of the regions of paint stand before each leaf, depth first.
class CountRegions {
 public:
  void in(const Shape& shape) {
    std::visit([this](const auto& expression) { in(expression); }, shape.expression);
  }
  std::vector<std::size_t> before_leaf;

 private:
  void in(const Everything&) {}
  void in(const Nothing&) {}
  void in(const HalfSpace&) { before_leaf.push_back(in_regions_); }
  void in(const Union& shape) { in(shape.operands); }
  void in(const Intersection& shape) { in(shape.operands); }
  void in(const Covered& shape) { in(*shape.over); }
  void in(const Painted& shape) {
    in_regions_ += leaves_of(*shape.where).size();
    in(*shape.over);
  }
  void in(const std::vector<Shape>& operands) {
    for (const Shape& operand : operands) in(operand);
  }

  std::size_t in_regions_ = 0;
};

std::vector<Leaf> with_regions(const Scene& scene) {
  CountRegions count;
  count.in(scene.shape);
  std::vector<Leaf> numbers;
  for (Leaf leaf = 0; leaf < count.before_leaf.size(); ++leaf)
    numbers.push_back(leaf + count.before_leaf[leaf]);
  return numbers;
}

std::vector<Leaf> without_zero_normals(const Scene& scene) {
  std::vector<Leaf> numbers;
  Leaf next = 0;
  for (const PlacedLeaf& leaf : leaves_of(scene.shape)) {
    numbers.push_back(next);
    if (leaf.half_space.normal != Vector{}) ++next;
  }
  return numbers;
}

std::vector<Leaf> equal_ones_once(const Scene& scene) {
  std::vector<HalfSpace> distinct;
  std::vector<Leaf> numbers;
  for (const PlacedLeaf& leaf : leaves_of(scene.shape)) {
    const auto known = std::find(distinct.begin(), distinct.end(), leaf.half_space);
    numbers.push_back(static_cast<Leaf>(known - distinct.begin()));
    if (known == distinct.end()) distinct.push_back(leaf.half_space);
  }
  return numbers;
}

// Leaves are numbered in the order of their depth.
std::vector<Leaf> breadth_first(const Scene& scene) {
  const std::vector<PlacedLeaf> leaves = leaves_of(scene.shape);
  std::vector<Leaf> order(leaves.size());
  for (Leaf leaf = 0; leaf < order.size(); ++leaf) order[leaf] = leaf;
  std::stable_sort(order.begin(), order.end(),
                   [&](Leaf a, Leaf b) { return leaves[a].around.size() < leaves[b].around.size(); });
  std::vector<Leaf> numbers(leaves.size());
  for (Leaf place = 0; place < order.size(); ++place) numbers[order[place]] = place;
  return numbers;
}

Prepare numbers_leaves(std::vector<Leaf> (*number)(const Scene&)) {
  return [number](const Scene& scene) -> Answering {
    return [right = std::make_shared<const Right>(scene), numbers = number(scene)](const Ask& ask) {
      Answer answer = right->answer(ask);
      auto* entry = std::get_if<EntryAnswer>(&answer);
      auto* border = entry ? std::get_if<Border>(entry) : nullptr;
      if (border) border->leaf = numbers[border->leaf];
      return answer;
    };
  };
}

}  // namespace

std::vector<Bug> numbering_bugs() {
  using enum Reach;
  constexpr Kind entry = Kind::entry;
  return {
      {"regions-have-leaves", entry, special, "the half-spaces of painted regions are numbered too",
       numbers_leaves(with_regions)},
      {"zero-normals-unnumbered", entry, extreme, "half-spaces with a zero normal get no number",
       numbers_leaves(without_zero_normals)},
      {"equal-leaves-once", entry, special, "equal half-spaces share a number",
       numbers_leaves(equal_ones_once)},
      {"numbered-by-depth", entry, special, "leaves are numbered breadth first",
       numbers_leaves(breadth_first)},
  };
}

}  // namespace groundtruth::planted
