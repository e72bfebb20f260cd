#pragma once
// Where the leg of a wheel meets the ground (SPEC section 5).

#include <variant>

#include <groundtruth/definition/prepared_scene.hpp>
#include <groundtruth/definition/wheel_frame.hpp>
#include <groundtruth/problem/answer.hpp>

namespace groundtruth::definition {

struct NoGround {};

struct Ground {
  Triple<Real> point_in_world;
  Vector normal_in_world;  // as written
  Friction friction;
  std::optional<double> maximum_force;
};

using Landing = std::variant<NoGround, StepFailure, Ground>;

// Phi from (x, y, z_min) to (x, y, z_max) of the wheel. Throws Refused, naming leaf and material, if the
// contact has no friction.
Landing landing(const PreparedScene& scene, const WheelFrame& frame, const Wheel& wheel,
                const Real& x_in_wheel, const Real& y_in_wheel);

}  // namespace groundtruth::definition
