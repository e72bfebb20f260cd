#pragma once
// Corners of sets of planes, in doubles.

#include <optional>
#include <vector>

#include <groundtruth/cases/landmarks.hpp>

namespace groundtruth::cases {

// Where the three planes meet, by Cramer's rule: exact if the planes are short dyadics and the point is one
// too, and the determinant divides without rest. Nothing if that is no finite point.
std::optional<Vector> meeting_point(const HalfSpace& a, const HalfSpace& b, const HalfSpace& c);

enum class Keep { feasible, all };

// The corners of all triples of which at least one plane is among the first `own_planes`; only those that
// lie, up to rounding, in all half-spaces, or all of them.
std::vector<Corner> corners_of(const std::vector<HalfSpace>& planes, std::size_t own_planes, Keep keep);

}  // namespace groundtruth::cases
