#pragma once
// Clipping a force on a surface, in exact numbers (SPEC section 4).

#include <groundtruth/definition/real.hpp>
#include <groundtruth/definition/surface.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::definition {

struct ClippedForce {
  Grip grip = Grip::stick;
  Triple<Real> force_in_wheel;
};

// Requires friction >= 0 and brake >= 0.
ClippedForce clipped(const Triple<Rational>& force_in_wheel, const Surface& surface, const Rational& friction,
                     const Rational& brake);

}  // namespace groundtruth::definition
