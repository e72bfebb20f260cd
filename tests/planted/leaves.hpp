#pragma once
// The leaves of a shape, and what they are made of.

#include <optional>
#include <vector>

#include <groundtruth/problem/shape.hpp>

#include "numbers.hpp"

namespace groundtruth::planted {

// A half-space and the expressions around it, the outermost first.
struct PlacedLeaf {
  HalfSpace half_space;
  std::vector<const Shape*> around;
};

// In the order of their numbers. They point into the shape.
std::vector<PlacedLeaf> leaves_of(const Shape& shape);

// -1, 0, 1: the point lies in the half-space's interior, on its plane, outside.
int side_of(const HalfSpace& half_space, const Place& point);

bool contains(const Shape& shape, const Place& point);

// SPEC section 2.
std::optional<MaterialIndex> material_of(const PlacedLeaf& leaf, const Place& point);

}  // namespace groundtruth::planted
