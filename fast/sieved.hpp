#pragma once
// What a range leaves open of an expression, and where the range certainly or possibly enters that. Not
// installed.

#include <cstdint>
#include <span>

#include <boost/container/small_vector.hpp>
#include <groundtruth/fast/cell.hpp>
#include <groundtruth/fast/expression.hpp>

namespace groundtruth::fast {

struct SievedExpression {
  // Laid out as in Expression, constants simplified away; cells are ranges of `leaves`. A lone node
  // `everything` or `nothing` if no leaf is left.
  boost::container::small_vector<Node, 64> nodes;
  OpenLeaves leaves;
};

// The expression that starts at `node`, with the leaves inside or outside of which the range certainly stays
// replaced by constants. `sieved` is emptied first.
void sieve(const Expression& expression, const Node* node, const Probe& probe, SievedExpression& sieved);

// By monotonicity (SPEC section 3): grown by all errors the expression is entered no later, shrunk no
// earlier, than it is.
Meeting meet(const SievedExpression& sieved);

// As for a cell (cell.hpp).
Leaf sole_leaf(const SievedExpression& sieved, const Meeting& meeting);

}  // namespace groundtruth::fast
