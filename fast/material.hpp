#pragma once
// Membership and materials at a point of a segment. Not installed.

#include <algorithm>
#include <optional>

#include <groundtruth/fast/scene.hpp>
#include <groundtruth/fast/segment.hpp>

namespace groundtruth::fast {

template <class Number>
bool contains(const Expression& expression, const Node* node, const Segment<Number>& segment, Number lambda) {
  const auto some_operand_is = [&](bool member) {
    for (const Node* operand = node + 1; operand != node + node->size; operand += operand->size)
      if (contains(expression, operand, segment, lambda) == member) return true;
    return false;
  };
  const auto is_inside_leaf = [&](const HalfSpace& leaf) {
    return segment.approach(leaf).side_at(lambda) != Side::outside;
  };
  switch (node->kind) {
    case NodeKind::nothing:
      return false;
    case NodeKind::everything:
      return true;
    case NodeKind::cell:
      return std::all_of(expression.leaves.begin() + node->first_leaf,
                         expression.leaves.begin() + node->end_leaf, is_inside_leaf);
    case NodeKind::union_of:
      return some_operand_is(true);
    case NodeKind::intersection_of:
      break;
  }
  return !some_operand_is(false);
}

// The material of a leaf at a point of its plane: the outermost rule that holds there.
template <class Number>
std::optional<MaterialIndex> material_at(const Scene& scene, Leaf leaf, const Segment<Number>& segment,
                                         Number lambda) {
  std::optional<MaterialIndex> material;
  for (auto place = scene.rule_of_leaf()[leaf]; place; place = scene.rules()[*place].outer_rule) {
    const MaterialRule& rule = scene.rules()[*place];
    if (rule.region) {
      const Expression& region = scene.regions()[*rule.region];
      if (!contains(region, region.nodes.data(), segment, lambda)) continue;
    }
    material = rule.material;
  }
  return material;
}

}  // namespace groundtruth::fast
