#pragma once
// Private to this folder.

#include <vector>

#include <groundtruth/problem/scene.hpp>

namespace groundtruth::judge {

// All leaves whose planes hold the place while every operand that meets them holds it too, ascending: those
// that may be faces there, and few others. A sieve: the place may be off by a rounding or two.
std::vector<Leaf> leaves_that_may_stand(const Shape& shape, const Vector& place);

}  // namespace groundtruth::judge
