#pragma once
// The shapes S+tau and S-tau of SPEC sections 3 and 6. Private to this folder.

#include <groundtruth/problem/scene.hpp>

namespace groundtruth::judge {

// Every leaf's offset d moved to d + metres ||n||, rounded away from d, so that what is grown holds at least
// the points it should, and what is shrunk (metres < 0) at most those. Off by an ulp of the result or two;
// tiny half-spaces are first written longer, as an ulp of theirs may be metres.
// Where the offset would leave the range of doubles the leaf becomes everything, or nothing. Regions of paint
// stay.
Shape with_planes_moved(const Shape& shape, double metres);

}  // namespace groundtruth::judge
