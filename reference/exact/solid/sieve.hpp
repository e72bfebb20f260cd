#pragma once
// The one room where floating point decides: it takes from the solid what certainly does not change along a
// segment, so that rationals are spent on the few leaves that may. Private to this folder.
//
// Guarantee: a leaf is replaced by everything (nothing) only if interval arithmetic proves Delta < 0 (> 0) at
// both ends of the range, hence, Delta being affine, on all of it. So the reduced expression has the same
// membership, the same entry point and the same faces at every point of the range (proofs-notes/faces.md, 4).

#include <array>
#include <utility>

#include <groundtruth/exact/solid/solid.hpp>

namespace groundtruth::exact {

// Bounds of each coordinate of a point.
using PointEnclosure = std::array<std::pair<double, double>, 3>;

// The solid's expression reduced to the leaves that may decide between the two points.
Expression sieve(const Solid& solid, const PointEnclosure& first, const PointEnclosure& last);

}  // namespace groundtruth::exact
