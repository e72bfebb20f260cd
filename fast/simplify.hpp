#pragma once
// Expressions with some leaves replaced by constants. Not installed.

#include <cstdint>

#include <groundtruth/fast/expression.hpp>

namespace groundtruth::fast {

enum class Truth : std::uint8_t { no, open, yes };

// As an operator a node is one of these: everything is the intersection of nothing at all, and nothing is
// such a union.
inline bool is_union(const Node& node) {
  return node.kind == NodeKind::union_of || node.kind == NodeKind::nothing;
}

// Copies expressions to the end of `nodes`, constants simplified away; cells then are ranges of the leaves
// that are left. An expression that becomes a constant leaves nothing behind.
// Leaves: `add(leaf)` says what the leaf is, and appends it to the leaves that are left if it is open;
// `size()` and `resize(size)` are of those.
template <class Leaves, class Nodes>
class Simplifier {
 public:
  Simplifier(Leaves& leaves, Nodes& nodes) : leaves_(leaves), nodes_(nodes) {}

  Truth add(const Node* node) {
    if (node->kind == NodeKind::cell) return add_cell(*node);
    const Truth absorbing = is_union(*node) ? Truth::yes : Truth::no;
    const std::size_t place = nodes_.size(), leaves_before = leaves_.size();
    nodes_.push_back({.kind = node->kind});
    for (const Node* operand = node + 1; operand != node + node->size; operand += operand->size) {
      if (add(operand) != absorbing) continue;
      nodes_.resize(place);
      leaves_.resize(leaves_before);
      return absorbing;
    }
    const std::size_t size = nodes_.size() - place;
    if (size == 1) {
      nodes_.resize(place);
      return absorbing == Truth::yes ? Truth::no : Truth::yes;
    }
    nodes_[place].size = static_cast<std::uint32_t>(size);
    return Truth::open;
  }

 private:
  Truth add_cell(const Node& node) {
    const auto first = static_cast<std::uint32_t>(leaves_.size());
    for (std::uint32_t leaf = node.first_leaf; leaf != node.end_leaf; ++leaf) {
      if (leaves_.add(leaf) != Truth::no) continue;
      leaves_.resize(first);
      return Truth::no;
    }
    const auto end = static_cast<std::uint32_t>(leaves_.size());
    if (end == first) return Truth::yes;
    nodes_.push_back({NodeKind::cell, 1, first, end});
    return Truth::open;
  }

  Leaves& leaves_;
  Nodes& nodes_;
};

}  // namespace groundtruth::fast
