#pragma once
// A positive Boolean expression of half-spaces, laid out flat for evaluation.

#include <cstddef>
#include <cstdint>
#include <vector>

#include <groundtruth/fast/large_vector.hpp>
#include <groundtruth/problem/shape.hpp>

namespace groundtruth::fast {

enum class NodeKind : std::uint8_t { everything, nothing, cell, union_of, intersection_of };

// Nodes stand in depth-first order. A cell is the intersection of the half-spaces [first_leaf, end_leaf):
// one half-space, or several that stand side by side in an intersection.
struct Node {
  NodeKind kind = NodeKind::nothing;
  std::uint32_t size = 1;  // of the node and all below it: the next sibling is `size` nodes further on
  std::uint32_t first_leaf = 0;
  std::uint32_t end_leaf = 0;
};

// Guarantees: the first node is the root and spans all nodes; leaves ascend from node to node; no union is
// an operand of a union, no intersection of an intersection, unless it was alone in another operator.
struct Expression {
  std::vector<Node> nodes;
  LargeVector<HalfSpace> leaves;  // as written, in the order in which they are written
};

}  // namespace groundtruth::fast
