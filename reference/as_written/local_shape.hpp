#pragma once
// What the solid looks like very near a point: which face it is entered by (SPEC section 3), in plain
// doubles.

#include <groundtruth/as_written/expression.hpp>
#include <groundtruth/as_written/segment.hpp>

namespace groundtruth::as_written {

enum class Neighbourhood {
  solid,  // the point is in the interior
  face,   // the point is on a face
  empty   // the solid is not here: lambda is no entry point
};

struct Local {
  Neighbourhood neighbourhood = Neighbourhood::empty;
  const Node* face = nullptr;  // the canonical leaf, for Neighbourhood::face
};

// The neighbourhood of x(lambda). Exact where doubles are: the planes through the point are those whose
// crossing parameter has the very bits of lambda (Segment::side), and the cone of directions is that of
// their normals. What doubles cannot do:
//  - planes that meet at the point may get parameters an ulp or more apart; all but the first to reach lambda
//    are then missing, and with them the interior points and admissible leaves they make;
//  - planes that are parallel, or share a line, up to rounding only may be taken for either.
Local local_shape(const Expression& expression, const Segment& segment, double lambda);

}  // namespace groundtruth::as_written
