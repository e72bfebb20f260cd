#pragma once
// The face rule of SPEC section 3 read word by word: directions v are all of a lattice, "stands" is
// simplification of the tree. A third opinion, for shapes whose normals are of -1, 0, 1 only: their planes
// through a point meet in lines along vectors of at most 2 a coordinate; two such span each sector of a
// plane, three each cell of space, so vectors of up to 4 and up to 6 a coordinate reach all of them.

#include <vector>

#include <groundtruth/tests/properties/membership.hpp>

namespace groundtruth::properties {

struct LiteralFaces {
  bool interior = false;
  std::vector<Leaf> admissible;  // ascending
};

// Requires that x(lambda) is the entry point.
LiteralFaces literal_faces(const Shape& shape, const EntryAsk& ask, const Rational& lambda);

}  // namespace groundtruth::properties
