#pragma once
// Scenes of any size. World z is up; lengths are in metres. The materials are those of ground_materials.hpp.

#include <cstddef>
#include <cstdint>

#include <groundtruth/problem/scene.hpp>

namespace groundtruth::cases {

// The source's house, 6 m x 8 m, ridge at z = 7, with a floor at z = 0: the six planes of the source in their
// order, then the floor. 7 leaves, all dry.
Scene house();

// Abutting dry boxes of 10 m x 30 m x 1 m along x from x = 0, with the one top plane z = 0, and a wet patch
// painted across the seams in the middle third. 6 leaves a box.
Scene runway_of(std::size_t boxes);

// Houses of the plan of house() on the ground z <= 0, with a wet road and a puddle of water painted on. The
// ground is leaf 0, then come 7 leaves a house. Sizes are multiples of 2^-10 m, places of 1/4 m. Three houses
// in four stand along the axes, one in eight is turned by the 3-4-5 angle, one in eight has planes of
// arbitrary doubles. Materials vary; one house in sixteen has none and one in sixteen is of glass.
Scene town_of(std::size_t houses, std::uint64_t seed);

// A heightfield over cells x cells squares of 8 m, each cut along its diagonal into two prisms that reach
// down to z = -8: 2 cells^2 prisms of 5 leaves (three sides, bottom, top). Heights are multiples of 1/4 m, so
// that all planes are exact and neighbours share exactly opposite ones. Ice is painted above z = 2.5.
Scene hills_of(std::size_t cells);

// Flat ground, a ramp of slope 1/4 that joins it at the foot x = 0, and a deck on top, with ice painted
// across the foot and another sheet of it higher up. 17 leaves.
Scene ramp();

// A random expression of at most `depth` nested unions and intersections of 1 to `operands` operands, over
// half-spaces with integer normals in [-2, 2]^3 and half-integer offsets in [-4, 4], boxes, and now and then
// everything, nothing, materials and paint. Requires operands > 0.
Scene random_nested(std::uint64_t seed, unsigned depth, unsigned operands);

// The scene moved by `offset`: every d becomes d + n . offset, rounded to double. It is exact if n and d are
// short dyadics, as most planes here are; else the result is a scene near the moved one.
Scene shifted(const Scene& scene, const Vector& offset);

}  // namespace groundtruth::cases
