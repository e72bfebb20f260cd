#pragma once
// Private to this folder.

#include <vector>

#include <groundtruth/cases/random.hpp>
#include <groundtruth/problem/scene.hpp>

namespace groundtruth::cases {

// The ground materials, half of the time with numbers of their own: coefficients above 1, dynamic above
// static friction, other limits, and tyres whose names resemble each other.
std::vector<Material> some_materials(Random& random);

}  // namespace groundtruth::cases
