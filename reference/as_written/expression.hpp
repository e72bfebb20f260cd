#pragma once
// A shape laid out flat: nodes in the order in which they are written, each followed by its operands.

#include <cstddef>
#include <vector>

#include <groundtruth/problem/shape.hpp>

namespace groundtruth::as_written {

enum class Operation { everything, nothing, half_space, union_of, intersection_of };

struct Node {
  Operation operation = Operation::nothing;
  std::size_t end = 0;   // the node after this one's last operand; the operands start at the next node
  HalfSpace half_space;  // of a half_space: never with a zero normal, which is everything or nothing
  Leaf leaf = 0;         // of a half_space of the solid
};

using Expression = std::vector<Node>;  // never empty; the root is node 0

}  // namespace groundtruth::as_written
