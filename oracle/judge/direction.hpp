#pragma once
// Normals against normals. Private to this folder.

#include <groundtruth/problem/vector.hpp>

namespace groundtruth::judge {

// Whether `got` is a positive multiple of `expected`, but for an angle of at most `radians` < pi/2; exactly
// so if that is 0. False if either is zero.
bool points_along(const Vector& got, const Vector& expected, double radians);

// The angle between the two, for people.
double degrees_between(const Vector& got, const Vector& expected);

}  // namespace groundtruth::judge
