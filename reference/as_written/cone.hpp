#pragma once
// The local cone of a solid at a point x and the faces that bound it (SPEC section 3), in plain doubles.

#include <cstddef>
#include <vector>

#include <groundtruth/as_written/expression.hpp>
#include <groundtruth/as_written/segment.hpp>

namespace groundtruth::as_written {

// What an expression comes to once some leaves are replaced by constants and these are simplified away.
enum class Remains { everything, nothing, some };

// A part of what is left of an expression at x: leaves whose planes pass through x, unions, intersections.
struct ConePart {
  Operation operation = Operation::half_space;
  std::size_t end = 0;         // the part after this one's last operand; the operands start at the next part
  const Node* face = nullptr;  // of a half_space
};

// The positive expression of the half-spaces {v : n . v <= 0} of those leaves, leaves in ascending order.
// Never empty, and free of constants: every leaf in it stands.
using Cone = std::vector<ConePart>;

// The canonical face where the segment arrives at x from elsewhere; null if none of the cone's faces is
// entered.
const Node* entered_face(const Cone& cone, const Segment& segment);

// The canonical face where the range starts at x; null if the cone is all of space, so that x is interior.
const Node* start_face(const Cone& cone);

}  // namespace groundtruth::as_written
