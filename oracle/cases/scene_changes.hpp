#pragma once
// A scene like a given one, but for a change: operands dropped, doubled, swapped, wrapped; planes moved by an
// ulp, scaled or turned; a union made an intersection; other materials.

#include <groundtruth/cases/random.hpp>
#include <groundtruth/problem/scene.hpp>

namespace groundtruth::cases {

// A function of the scene and what `random` draws alone. Never grows beyond a few more leaves.
Scene changed(const Scene& scene, Random& random);

}  // namespace groundtruth::cases
