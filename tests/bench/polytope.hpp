#pragma once
// Scenes as what other libraries take: corners and triangles, in doubles, with no claim to exactness.

#include <array>
#include <cstdint>
#include <vector>

#include <groundtruth/problem/scene.hpp>

namespace groundtruth::bench {

using Cell = std::vector<HalfSpace>;

// The operands of a union of convex cells, materials left aside. Throws std::invalid_argument for other
// shapes.
std::vector<Cell> cells_of(const Scene& scene);

struct Polytope {
  std::vector<Vector> corners;
  std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise from outside
};

// The border of a cell, cut off at |x|, |y|, |z| <= reach.
Polytope polytope_of(const Cell& cell, double reach);

}  // namespace groundtruth::bench
