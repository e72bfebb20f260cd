#include "step_scales.hpp"

#include <algorithm>
#include <cmath>

#include "spread.hpp"

namespace groundtruth::judge {
namespace {

using Real = long double;
using RealVector = std::array<Real, 3>;

// Eight units in the last place: the strut's end, the ground's height over it, the point of landing.
constexpr Real roundings_in_world = 8 * 0x1p-52L;

Real length(const RealVector& v) { return std::hypot(v[0], v[1], v[2]); }
RealVector real(const Vector& v) { return {v[0], v[1], v[2]}; }
RealVector minus(const RealVector& a, const RealVector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
RealVector cross(const RealVector& a, const RealVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// q^-1 v q, by v + 2 w (v x u) + 2 u x (u x v) with q of unit length.
RealVector to_wheel(const Quaternion& q, const RealVector& v) {
  const Real size = std::hypot(std::hypot(static_cast<Real>(q[0]), static_cast<Real>(q[1])),
                               std::hypot(static_cast<Real>(q[2]), static_cast<Real>(q[3])));
  const Real w = q[0] / size;
  const RealVector u{q[1] / size, q[2] / size, q[3] / size};
  const RealVector once = cross(v, u);
  const RealVector twice = cross(u, cross(u, v));
  return {v[0] + 2 * (w * once[0] + twice[0]), v[1] + 2 * (w * once[1] + twice[1]),
          v[2] + 2 * (w * once[2] + twice[2])};
}

// Of unit length, whatever its own.
RealVector unit(const Vector& v) {
  const Real size = judge::length(v);
  return {v[0] / size, v[1] / size, v[2] / size};
}

}  // namespace

StepScales scales_of(const StepAsk& ask) {
  const Wheel& wheel = ask.wheel;
  const Frame& frame = ask.frame;
  StepScales scales;
  scales.world = roundings_in_world * length(frame.position_in_world);
  scales.length = std::max(std::fabs(wheel.z_min), std::fabs(wheel.z_max));
  scales.landing = scales.length;
  const auto* contact = std::get_if<Contact>(&ask.state);
  if (contact == nullptr) return scales;
  scales.world = std::max(scales.world, roundings_in_world * length(contact->pebble_in_world));
  const Real pebble = length(minus(real(contact->pebble_in_world), real(frame.position_in_world)));
  const Real speed = length(contact->pebble_velocity_in_world) + length(frame.velocity_in_world) +
                     length(frame.angular_velocity_in_world) * pebble;
  const Real k_xy = std::fabs(wheel.k_xy);
  const Real d_xy = std::fabs(wheel.d_xy);
  const Real spring = std::max(k_xy, static_cast<Real>(std::fabs(wheel.k_z))) * pebble +
                      std::fabs(static_cast<Real>(wheel.k_z) * wheel.z_zero);
  const Real damper = std::max(d_xy, static_cast<Real>(std::fabs(wheel.d_z))) * speed;
  const double friction = contact->grip == Grip::stick ? contact->static_friction : contact->dynamic_friction;
  scales.force = spring + damper;
  scales.clipped = scales.force * std::max(1.0, friction);
  scales.length = std::max(pebble, scales.length);
  const bool mapping = wheel.relocation == Relocation::return_mapping;
  scales.stiffness = mapping ? k_xy + d_xy / ask.h : k_xy;
  const Real of_mapping = mapping ? d_xy / ask.h * pebble + d_xy * speed : 0;
  scales.landing += (scales.clipped + of_mapping) / scales.stiffness;
  scales.velocity =
      std::max(length(contact->pebble_velocity_in_world), std::max(scales.landing, pebble) / ask.h);
  return scales;
}

Sight sight_of(const Contact& contact, const StepAsk& ask) {
  const Frame& frame = ask.frame;
  const Wheel& wheel = ask.wheel;
  const RealVector arm = minus(real(contact.pebble_in_world), real(frame.position_in_world));
  const RealVector turning = cross(real(frame.angular_velocity_in_world), arm);
  const RealVector velocity_in_world =
      minus(minus(real(contact.pebble_velocity_in_world), real(frame.velocity_in_world)), turning);
  Sight sight;
  const RealVector p = to_wheel(frame.world_from_wheel, arm);
  const RealVector w = to_wheel(frame.world_from_wheel, velocity_in_world);
  const RealVector n = to_wheel(frame.world_from_wheel, unit(contact.normal_in_world));
  const RealVector force{wheel.k_xy * p[0] + wheel.d_xy * w[0], wheel.k_xy * p[1] + wheel.d_xy * w[1],
                         wheel.k_z * (p[2] - wheel.z_zero) + wheel.d_z * w[2]};
  sight.pebble_in_wheel = p;
  sight.normal_in_wheel = n;
  sight.pressing = -(force[0] * n[0] + force[1] * n[1] + force[2] * n[2]);
  return sight;
}

long double amplification(const Vector& normal_in_world, const Frame& frame) {
  const Real along = std::fabs(to_wheel(frame.world_from_wheel, unit(normal_in_world))[2]);
  return 1 / along;
}

}  // namespace groundtruth::judge
