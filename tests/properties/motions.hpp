#pragma once
// Scenes and asks moved together, exactly: what must not change an answer.

#include <array>

#include <groundtruth/tests/properties/generators.hpp>

namespace groundtruth::properties {

// x -> matrix x + shift. Exact on small whole numbers if its own are.
struct AffineMap {
  std::array<Vector, 3> matrix{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  // rows; not singular
  Vector shift{};

  Vector point(const Vector& x) const;
  // Of the half-space, the image: its normal is a positive multiple of matrix^-T n.
  HalfSpace half_space(const HalfSpace& h) const;
  EntryCase operator()(const EntryCase& c) const;
};

Vector product(const std::array<Vector, 3>& matrix, const Vector& vector);

// ||q||^2 times the rotation of a quaternion of whole numbers.
std::array<Vector, 3> scaled_rotation(const Quaternion& q);
double squared_length(const Quaternion& q);
// First `right`, then `left`.
Quaternion product(const Quaternion& left, const Quaternion& right);

// A rotation that maps the axes to the axes: one of the 24, as a quaternion of -1, 0 and 1.
Quaternion quarter_turns(Dice& dice);

// The world turned by q about its origin, then shifted. Requires that every coordinate of the case is a
// multiple of squared_length(q), if that is not 1, 2 or 4 from quarter_turns().
StepCase moved(const StepCase& c, const Quaternion& q, const Vector& shift);

// All lengths, and with them velocities and forces, times `factor`. (Not the palette's maximum force.)
StepCase enlarged(const StepCase& c, double factor);

// The world, the frame and the state seen in a mirror that turns round this axis (x or y) of world and wheel.
StepCase mirrored(const StepCase& c, std::size_t axis);

}  // namespace groundtruth::properties
