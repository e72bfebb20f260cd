#include <array>
#include <cmath>
#include <cstdlib>

#include <groundtruth/cases/step_parts.hpp>
#include <groundtruth/cases/vector_arithmetic.hpp>

namespace groundtruth::cases {

Quaternion product(const Quaternion& p, const Quaternion& q) {
  return {p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
          p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
          p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
          p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]};
}

Vector rotated(const Quaternion& q, const Vector& v) {
  const Vector axis{q[1], q[2], q[3]};
  const double square = q[0] * q[0] + dot(axis, axis);
  const Vector turned = plus(plus(times(q[0] * q[0] - dot(axis, axis), v), times(2 * dot(axis, v), axis)),
                             times(2 * q[0], cross(axis, v)));
  return {turned[0] / square, turned[1] / square, turned[2] / square};
}

Quaternion upright_on(const Vector& normal_in_world, Random& random) {
  const Vector& n = normal_in_world;
  // Half-way between the wheel's z and -n.
  Quaternion down{length(n) - n[2], n[1], 0 - n[0], 0};
  if (down == Quaternion{} || (n[0] == 0 && n[1] == 0 && n[2] > 0)) down = {0, 1, 0, 0};
  Quaternion yaw{};
  while (yaw == Quaternion{}) yaw = {random.dyadic(-5, 5, 0), 0, 0, random.dyadic(-5, 5, 0)};
  Quaternion tilt{1, 0, 0, 0};
  if (random.one_in(2)) {
    tilt = {64, random.dyadic(-8, 8, 0), random.dyadic(-8, 8, 0), random.dyadic(-8, 8, 0)};
  }
  Quaternion result = product(down, product(yaw, tilt));
  if (random.one_in(2)) return result;
  double square = 0;
  for (double component : result) square += component * component;
  const double size = random.one_in(2) ? 1.0 : random.magnitude(-3, 3);
  for (double& component : result) component *= size / std::sqrt(square);
  return result;
}

Quaternion right_angle_orientation(Random& random) {
  static constexpr std::array<Quaternion, 4> z_down{
      {{0, 1, 0, 0}, {0, 0, 1, 0}, {0, 1, 1, 0}, {0, 1, -1, 0}}};
  static constexpr std::array<Quaternion, 12> others{{{1, 0, 0, 0},
                                                      {0, 0, 0, 1},
                                                      {1, 0, 0, 1},
                                                      {1, 1, 0, 0},
                                                      {1, -1, 0, 0},
                                                      {1, 0, 1, 0},
                                                      {1, 0, -1, 0},
                                                      {0, 1, 0, 1},
                                                      {0, 0, 1, -1},
                                                      {1, 1, 1, 1},
                                                      {1, -1, 1, 1},
                                                      {-1, 1, 1, 1}}};
  return random.one_in(4) ? random.pick(others) : random.pick(z_down);
}

Wheel realistic_wheel(Random& random) {
  Wheel wheel;
  wheel.k_xy = -random.magnitude(13, 20);
  wheel.k_z = -random.magnitude(13, 20);
  wheel.d_xy = random.one_in(8) ? 0 : -random.magnitude(6, 13);
  wheel.d_z = random.one_in(8) ? 0 : -random.magnitude(6, 13);
  wheel.z_min = random.uniform(0.1, 0.4) - (random.one_in(8) ? 0.5 : 0.0);
  wheel.z_zero = wheel.z_min + random.uniform(0.1, 0.6);
  wheel.z_max = wheel.z_zero + (random.one_in(4) ? random.uniform(0, 0.3) : 0);
  wheel.tyre = random.one_in(6) ? "metal" : "rubber";
  wheel.relocation = random.one_in(2) ? Relocation::return_mapping : Relocation::spring;
  return wheel;
}

Wheel short_wheel(Random& random) {
  Wheel wheel = realistic_wheel(random);
  const auto power = [&](std::int64_t first, std::int64_t last) {
    return -std::ldexp(1.0, static_cast<int>(random.between(first, last)));
  };
  wheel.k_xy = power(14, 18);
  wheel.k_z = power(14, 18);
  wheel.d_xy = random.one_in(4) ? 0 : power(6, 12);
  wheel.d_z = random.one_in(4) ? 0 : power(6, 12);
  wheel.z_min = random.one_in(8) ? -0.25 : 0.25;
  wheel.z_zero = 1;
  wheel.z_max = random.one_in(2) ? 1 : 2;
  return wheel;
}

double time_step(Random& random) {
  switch (random.below(3)) {
    case 0:
      return 0.001;
    case 1:
      return std::ldexp(1.0, static_cast<int>(random.between(-13, -7)));
    default:
      return random.uniform(1e-4, 1e-2);
  }
}

Frame frame_with(const Quaternion& world_from_wheel, const Vector& point_in_wheel,
                 const Vector& point_in_world) {
  Frame frame;
  frame.world_from_wheel = world_from_wheel;
  frame.position_in_world = minus(point_in_world, rotated(world_from_wheel, point_in_wheel));
  return frame;
}

Contact contact_at(const FacePoint& place, const Wheel& wheel, const Landmarks& landmarks, Random& random) {
  Contact contact;
  contact.grip = random.one_in(2) ? Grip::slip : Grip::stick;
  contact.pebble_in_world = place.point;
  contact.normal_in_world = place.plane.normal;
  contact.static_friction = random.uniform(0.05, 1);
  contact.dynamic_friction = contact.static_friction * random.uniform(0.5, 1);
  if (landmarks.materials.empty() || random.one_in(4)) return contact;
  const Material& material = random.pick(landmarks.materials);
  const auto friction = material.friction_by_tyre.find(wheel.tyre);
  if (friction == material.friction_by_tyre.end()) return contact;
  contact.static_friction = friction->second.static_coefficient;
  contact.dynamic_friction = friction->second.dynamic_coefficient;
  // Not always: many of the materials would give way under most wheels.
  if (random.one_in(2)) contact.maximum_force = material.maximum_force;
  return contact;
}

}  // namespace groundtruth::cases
