#pragma once
// Where a wheel's suspension meets the ground.

#include <string>
#include <variant>

#include <groundtruth/as_written/errata.hpp>
#include <groundtruth/as_written/scene.hpp>
#include <groundtruth/as_written/vector_algebra.hpp>
#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::as_written {

// The place of a wheel frame: T(p) = position + axes p.
struct Placement {
  Vector position_in_world{};
  Axes world_from_wheel;
};

Placement placement_of(const Frame& frame);

Vector to_world(const Placement& placement, const Vector& point_in_wheel);
Vector to_wheel(const Placement& placement, const Vector& point_in_world);

// Free: nothing is met before z_max. Otherwise the contact, its grip and pebble velocity left to the caller.
using Meeting = std::variant<Free, Contact, StepFailure, Refusal>;

// Lowers the wheel at (x, y) in wheel coordinates from z_min to z_max.
Meeting meet_ground(const Scene& scene, const Wheel& wheel, const Placement& placement, double x, double y,
                    const Errata& errata);

}  // namespace groundtruth::as_written
