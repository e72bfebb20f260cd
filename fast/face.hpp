#pragma once
// The face of a solid at a point of its border (SPEC section 3). Not installed.

#include <cstdint>
#include <optional>

#include <boost/container/small_vector.hpp>
#include <groundtruth/fast/expression.hpp>
#include <groundtruth/fast/segment.hpp>

namespace groundtruth::fast {

// A node of the solid's local shape at a point: an operator, or a leaf whose plane contains the point.
struct LocalNode {
  NodeKind kind = NodeKind::cell;  // cell: the one leaf
  std::uint32_t size = 1;
  Leaf leaf = 0;
  bool is_entered = false;  // by the segment
};

// What is left of the solid at a point once every leaf whose plane does not contain the point is replaced
// by its value there and constants are simplified away: all leaves in it stand, and ascend.
using LocalNodes = boost::container::small_vector<LocalNode, 64>;

enum class Value { nothing, everything, open };

struct LocalShape {
  Value value = Value::open;
  LocalNodes nodes;  // empty unless the value is open
};

template <class Number>
LocalShape local_shape(const Expression& solid, const Segment<Number>& segment, Number lambda);

// Is the local shape all of space?
bool is_interior(const LocalShape& shape, const Expression& solid);

enum class Candidates { entered_leaves, all_leaves };

// The smallest admissible leaf. Requires a value `open` and at least one candidate among the leaves.
// Decides with signs of determinants of the normals in wide numbers: unproved where they are not exact.
Leaf canonical_leaf(const LocalShape& shape, const Expression& solid, Candidates candidates);

}  // namespace groundtruth::fast
