#pragma once
// Small scenes of shapes that nobody would build on purpose: the places where engines differ.

#include <vector>

#include <groundtruth/problem/scene.hpp>

namespace groundtruth::cases {

// Solids thinner than they should be: sheets, needles, points, slivers, cracks of one ulp.
std::vector<Scene> thin_scenes();

// Planes that coincide, oppose or meet in too great a number; solids that touch in a face, an edge, a corner.
std::vector<Scene> coincident_scenes();

// Zero normals, normals of extreme length, and planes beyond the range in which doubles are dense.
std::vector<Scene> odd_plane_scenes();

// Expressions that say something simple in a complicated way: empty operands, constants, repetition, nesting.
std::vector<Scene> odd_expression_scenes();

}  // namespace groundtruth::cases
