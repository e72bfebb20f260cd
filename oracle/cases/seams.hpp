#pragma once
// Where pieces abut.

#include <vector>

#include <groundtruth/cases/landmarks.hpp>

namespace groundtruth::cases {

// Either all finite or all of space.
struct PieceBounds {
  Vector low{};
  Vector high{};
};

// Pairs of planes with the same doubles and opposite signs (zero has none), of pieces whose bounds touch:
// both ways, but only from the bounded piece if the other one is not. Where very many pieces share a plane
// only those near each other in the order of pieces are paired, so that the time stays proportional to the
// number of planes.
std::vector<Seam> find_seams(const std::vector<Piece>& pieces, const std::vector<PieceBounds>& bounds);

}  // namespace groundtruth::cases
