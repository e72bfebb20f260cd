#pragma once
// Which faces meet at a point of the solid, and whether the point is interior: the local cone of SPEC
// section 3. Private to this folder. Derivation: proofs-notes/faces.md.

#include <vector>

#include <groundtruth/exact/arithmetic/rational.hpp>
#include <groundtruth/exact/solid/expression.hpp>

namespace groundtruth::exact {

// A leaf whose plane goes through the point; its normal is not zero.
struct LocalLeaf {
  Leaf leaf = 0;
  RationalVector normal;
  bool counts = true;  // the segment enters its half-space here, or starts here
};

struct LocalFaces {
  bool interior = false;
  std::vector<Leaf> admissible;  // ascending; empty iff interior
};

// `cone` is the solid's expression with every leaf whose plane misses the point replaced by its value there,
// and constants simplified away; its leaves are places in `leaves`. Requires that the point lies in the
// solid.
LocalFaces faces_at(const Expression& cone, const std::vector<LocalLeaf>& leaves);

}  // namespace groundtruth::exact
