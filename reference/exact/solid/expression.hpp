#pragma once
// A Boolean expression laid out in preorder, so that reducing it is copying part of it. Private to this
// folder.

#include <cstddef>
#include <vector>

#include <groundtruth/problem/shape.hpp>

namespace groundtruth::exact {

enum class Operation { everything, nothing, leaf, united, intersected };

// The operands of nodes[i] start at i + 1; each next one at the `end` of the one before, up to nodes[i].end.
struct Node {
  Operation operation;
  std::size_t end;
  Leaf leaf = 0;  // of an Operation::leaf
};
using Expression = std::vector<Node>;

// The value of an expression whose leaves are known true, known false, or not known. "Not known" is not
// looked into: x united with its complement is not known. That is how SPEC section 3 simplifies constants.
enum class Truth { no, unknown, yes };

// Truth of the node at `at`, where truth_of_leaf(Leaf) gives that of its leaves.
template <typename TruthOfLeaf>
Truth evaluate(const Expression& expression, std::size_t at, const TruthOfLeaf& truth_of_leaf) {
  const Node& node = expression[at];
  switch (node.operation) {
    case Operation::everything:
      return Truth::yes;
    case Operation::nothing:
      return Truth::no;
    case Operation::leaf:
      return truth_of_leaf(node.leaf);
    default:
      break;
  }
  const bool united = node.operation == Operation::united;
  const Truth swallowing = united ? Truth::yes : Truth::no;
  Truth result = united ? Truth::no : Truth::yes;
  for (std::size_t operand = at + 1; operand < node.end; operand = expression[operand].end) {
    const Truth truth = evaluate(expression, operand, truth_of_leaf);
    if (truth == swallowing) return swallowing;
    if (truth == Truth::unknown) result = Truth::unknown;
  }
  return result;
}

// Appends to `out` what of the node at `at` is not constant: the leaves that stand (SPEC section 3). Appends
// nothing unless the result is Truth::unknown.
template <typename TruthOfLeaf>
Truth append_reduced(const Expression& expression, std::size_t at, const TruthOfLeaf& truth_of_leaf,
                     Expression& out) {
  const Node& node = expression[at];
  if (node.operation == Operation::everything) return Truth::yes;
  if (node.operation == Operation::nothing) return Truth::no;
  const std::size_t start = out.size();
  if (node.operation == Operation::leaf) {
    const Truth truth = truth_of_leaf(node.leaf);
    if (truth == Truth::unknown) out.push_back({Operation::leaf, start + 1, node.leaf});
    return truth;
  }
  const Truth swallowing = node.operation == Operation::united ? Truth::yes : Truth::no;
  const Truth neutral = node.operation == Operation::united ? Truth::no : Truth::yes;
  out.push_back({node.operation, 0});
  for (std::size_t operand = at + 1; operand < node.end; operand = expression[operand].end) {
    if (append_reduced(expression, operand, truth_of_leaf, out) == swallowing) {
      out.resize(start, {Operation::nothing, 0});
      return swallowing;
    }
  }
  if (out.size() == start + 1) {
    out.pop_back();
    return neutral;
  }
  out[start].end = out.size();
  return Truth::unknown;
}

// The expression with constants simplified away; a single constant node if nothing else is left.
template <typename TruthOfLeaf>
Expression reduced(const Expression& expression, const TruthOfLeaf& truth_of_leaf) {
  Expression out;
  const Truth truth = append_reduced(expression, 0, truth_of_leaf, out);
  if (truth != Truth::unknown) {
    out.push_back({truth == Truth::yes ? Operation::everything : Operation::nothing, 1});
  }
  return out;
}

}  // namespace groundtruth::exact
