#pragma once
// The pebble border disc and band (SPEC section 4): the closest point it has to a force, by trying all points
// that can be the closest.

#include <groundtruth/definition/real.hpp>

namespace groundtruth::definition {

struct PebbleBorder {
  Real radius;      // mu N >= 0
  Real half_width;  // B >= 0
};

struct TangentForce {
  Real x, y;
};

bool is_inside(const TangentForce& force, const PebbleBorder& border);

// Of the points of the border, the closest to `force`: unique, as the border is convex.
TangentForce closest_inside(const TangentForce& force, const PebbleBorder& border);

}  // namespace groundtruth::definition
