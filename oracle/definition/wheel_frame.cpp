#include <groundtruth/definition/wheel_frame.hpp>

namespace groundtruth::definition {
namespace {

using RationalQuaternion = std::array<Rational, 4>;

RationalQuaternion product(const RationalQuaternion& a, const RationalQuaternion& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
          a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
          a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

// q v q^-1
Triple<Rational> rotated(const RationalQuaternion& q, const Triple<Rational>& v) {
  const RationalQuaternion conjugate{q[0], -q[1], -q[2], -q[3]};
  const Rational norm = product(q, conjugate)[0];
  const RationalQuaternion r = product(product(q, {0, v[0], v[1], v[2]}), conjugate);
  return {r[1] / norm, r[2] / norm, r[3] / norm};
}

}  // namespace

WheelFrame::WheelFrame(const Frame& frame)
    : position_in_world_(rational(frame.position_in_world)),
      velocity_in_world_(rational(frame.velocity_in_world)),
      angular_velocity_in_world_(rational(frame.angular_velocity_in_world)) {
  RationalQuaternion q;
  for (std::size_t i = 0; i < 4; ++i) q[i] = rational(frame.world_from_wheel[i]);
  axes_in_world_ = {rotated(q, {1, 0, 0}), rotated(q, {0, 1, 0}), rotated(q, {0, 0, 1})};
}

Triple<Real> WheelFrame::world_from_wheel_direction(const Triple<Real>& in_wheel) const {
  return in_wheel[0] * axes_in_world_[0] + in_wheel[1] * axes_in_world_[1] + in_wheel[2] * axes_in_world_[2];
}

Triple<Real> WheelFrame::world_from_wheel_point(const Triple<Real>& in_wheel) const {
  return real(position_in_world_) + world_from_wheel_direction(in_wheel);
}

Triple<Rational> WheelFrame::wheel_from_world_direction(const Triple<Rational>& in_world) const {
  return {dot(axes_in_world_[0], in_world), dot(axes_in_world_[1], in_world),
          dot(axes_in_world_[2], in_world)};
}

Triple<Rational> WheelFrame::wheel_from_world_point(const Triple<Rational>& in_world) const {
  return wheel_from_world_direction(in_world - position_in_world_);
}

Triple<Rational> WheelFrame::velocity_in_world(const Triple<Rational>& point_in_world) const {
  return velocity_in_world_ + cross(angular_velocity_in_world_, point_in_world - position_in_world_);
}

}  // namespace groundtruth::definition
