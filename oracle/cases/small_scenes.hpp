#pragma once
// Small scenes without end, each a place where implementations differ: seams, stacks, corners, sheets, nested
// and repeated expressions, odd planes, far from the origin or near it. They have few leaves (about 40 at the
// most), so that exact answers about them are cheap.

#include <groundtruth/cases/random.hpp>
#include <groundtruth/problem/scene.hpp>

namespace groundtruth::cases {

// A function of what `random` draws alone. Materials are those of ground_materials.hpp.
Scene small_scene(Random& random);

}  // namespace groundtruth::cases
