#pragma once
// The frame of a wheel, in exact numbers: T_{b,q} and f_q of SPEC section 5.

#include <groundtruth/definition/real.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::definition {

class WheelFrame {
 public:
  // Requires a quaternion other than 0.
  explicit WheelFrame(const Frame& frame);

  Triple<Real> world_from_wheel_point(const Triple<Real>& in_wheel) const;
  Triple<Real> world_from_wheel_direction(const Triple<Real>& in_wheel) const;
  Triple<Rational> wheel_from_world_point(const Triple<Rational>& in_world) const;
  Triple<Rational> wheel_from_world_direction(const Triple<Rational>& in_world) const;

  // The velocity in the world of the frame's matter at a point of the world.
  Triple<Rational> velocity_in_world(const Triple<Rational>& point_in_world) const;

 private:
  Triple<Rational> position_in_world_;
  Triple<Rational> velocity_in_world_;
  Triple<Rational> angular_velocity_in_world_;
  Triple<Triple<Rational>> axes_in_world_;  // of the wheel: the columns of the rotation
};

}  // namespace groundtruth::definition
