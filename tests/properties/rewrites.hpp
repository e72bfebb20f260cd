#pragma once
// Shapes written in another way.

#include <groundtruth/tests/properties/dice.hpp>
#include <groundtruth/tests/properties/shapes.hpp>

namespace groundtruth::properties {

struct Rewritten {
  Shape shape;
  std::vector<Leaf> old_leaf;  // by leaf of `shape`: which one of the original it is (a copy of)
};

// Each operation's operands in any order.
Rewritten with_operands_permuted(const Shape& shape, Dice& dice);
// Some operands twice or three times.
Rewritten with_operands_duplicated(const Shape& shape, Dice& dice);

// No union is an operand of a union, no intersection of an intersection.
Shape flattened(const Shape& shape);

}  // namespace groundtruth::properties
