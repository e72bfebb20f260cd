#pragma once
// What follows for an expression from what is known of its leaves. Not installed.

#include <groundtruth/fast/simplify.hpp>

namespace groundtruth::fast {

enum class Operator : std::uint8_t { union_of, intersection_of };

// Algebra: a `Value`, `of_none(op)` (false for a union, true for an intersection), `of_leaf(place)`,
// `join(op, all, one)`, which takes one more operand's value into account, and `is_settled(op, all)`: no more
// operands need be looked at.
template <class Algebra>
typename Algebra::Value evaluate(const Algebra& algebra, const Node* node) {
  const Operator op = is_union(*node) ? Operator::union_of : Operator::intersection_of;
  typename Algebra::Value all = algebra.of_none(op);
  if (node->kind == NodeKind::cell) {
    for (std::size_t leaf = node->first_leaf; leaf != node->end_leaf && !algebra.is_settled(op, all); ++leaf)
      algebra.join(op, all, algebra.of_leaf(leaf));
    return all;
  }
  for (const Node* operand = node + 1; operand != node + node->size && !algebra.is_settled(op, all);
       operand += operand->size)
    algebra.join(op, all, evaluate(algebra, operand));
  return all;
}

}  // namespace groundtruth::fast
