#pragma once
// A plane through the origin, cut by other such planes.

#include <vector>

#include <groundtruth/problem/vector.hpp>

namespace groundtruth::as_written {

// One direction from the inside of every sector into which the planes with the other normals cut the plane
// with this normal; any one direction if there are no others. No normal is zero, and none of the others is
// parallel to the first. Lines that coincide but for rounding leave a sliver between them.
std::vector<Vector> sectors_of_plane(const Vector& normal, const std::vector<Vector>& other_normals);

}  // namespace groundtruth::as_written
