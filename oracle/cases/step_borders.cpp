// Wheels on the ground exactly on a border between two answers.

#include <algorithm>
#include <cmath>
#include <variant>

#include <groundtruth/cases/border_cases.hpp>
#include <groundtruth/cases/entry_passing.hpp>
#include <groundtruth/cases/step_flavours.hpp>
#include <groundtruth/cases/step_parts.hpp>
#include <groundtruth/cases/vector_arithmetic.hpp>

namespace groundtruth::cases {
namespace {

// A power of two between 2 and 4 times as large in size, negative; any of them if the force is zero.
double stiffness_for(double force) {
  if (force == 0) return -0x1p16;
  return -std::ldexp(1.0, std::ilogb(force) + 2);
}

// A wheel at rest whose springs give this force, the pebble standing on a face: every number is short, so
// that the force is exact. p_z is within 1/2 of z_zero.
StepAsk at_rest_with_force(const Vector& force_in_wheel, const Vector& normal_in_wheel,
                           const Landmarks& landmarks, Random& random) {
  const Vector& force = force_in_wheel;
  StepAsk ask;
  ask.wheel = short_wheel(random);
  ask.wheel.k_xy = stiffness_for(std::max(std::abs(force[0]), std::abs(force[1])));
  ask.wheel.k_z = stiffness_for(force[2]);
  ask.wheel.z_max = 2;
  ask.wheel.min_uprightness = 0.03125;
  ask.h = std::ldexp(1.0, static_cast<int>(random.between(-12, -6)));

  const Quaternion world_from_wheel = right_angle_orientation(random);
  const Vector pebble_in_wheel{force[0] / ask.wheel.k_xy, force[1] / ask.wheel.k_xy,
                               ask.wheel.z_zero + force[2] / ask.wheel.k_z};
  FacePoint place = foothold(landmarks, random);
  ask.frame = frame_with(world_from_wheel, pebble_in_wheel, place.point);
  place.plane.normal = rotated(world_from_wheel, normal_in_wheel);
  ask.state = contact_at(place, ask.wheel, landmarks, random);
  std::get<Contact>(ask.state).maximum_force = std::nullopt;
  return ask;
}

StepAsk on_border(const BorderCase& border, const Landmarks& landmarks, Random& random) {
  StepAsk ask = at_rest_with_force(border.force_in_wheel, border.surface.normal, landmarks, random);
  ask.brake = border.brake;
  auto& contact = std::get<Contact>(ask.state);
  // The coefficient of the other grip stays off the border.
  (contact.grip == Grip::stick ? contact.static_friction : contact.dynamic_friction) = border.friction;
  return ask;
}

BorderCase random_border(BorderPlace place, Random& random) {
  const double unit = std::ldexp(1.0, static_cast<int>(random.between(-6, 4)));
  return border_case(place, Pressing::yes, unit, random);
}

}  // namespace

StepAsk step_border(const Landmarks& landmarks, Random& random) {
  static constexpr BorderPlace places[] = {BorderPlace::disc,
                                           BorderPlace::band_edge,
                                           BorderPlace::corner,
                                           BorderPlace::between_1_and_2,
                                           BorderPlace::between_2_and_3,
                                           BorderPlace::wide_band};
  const BorderPlace place = random.pick(places);
  return on_border(random_border(place, random), landmarks, random);
}

StepAsk step_lands_on_feature(const Landmarks& landmarks, Random& random) {
  // There H = (B, s) with a rational s, which is where it was: only x gives way. The surface lies level.
  BorderCase border = random_border(BorderPlace::between_1_and_2, random);
  while (border.surface.normal[0] != 0 || border.surface.normal[1] != 0) {
    border = random_border(BorderPlace::between_1_and_2, random);
  }
  StepAsk ask = on_border(border, landmarks, random);
  ask.wheel.relocation = Relocation::spring;
  const double new_x = std::copysign(border.brake, border.force_in_wheel[0]) / ask.wheel.k_xy;
  const double new_y = border.force_in_wheel[1] / ask.wheel.k_xy;
  double new_z = random.dyadic(0, 1, 4) + 0.5;
  if (random.one_in(4)) new_z = random.one_in(2) ? ask.wheel.z_min : ask.wheel.z_max;

  Feature feature = any_feature(landmarks, random);
  for (int tries = 0; tries < 3 && feature.normal[2] <= 0; ++tries) feature = any_feature(landmarks, random);
  const Vector before = ask.frame.position_in_world;
  ask.frame = frame_with(ask.frame.world_from_wheel, {new_x, new_y, new_z}, feature.point);
  auto& contact = std::get<Contact>(ask.state);
  contact.pebble_in_world = plus(contact.pebble_in_world, minus(ask.frame.position_in_world, before));
  return ask;
}

StepAsk step_gives_way(const Landmarks& landmarks, Random& random) {
  const BorderCase border = random_border(BorderPlace::disc, random);
  StepAsk ask = on_border(border, landmarks, random);
  // F'_z = -F . n / |n|, and the lengths are rational.
  const double pressure = -dot(border.force_in_wheel, border.surface.normal) / border.surface.length;
  std::get<Contact>(ask.state).maximum_force = pressure;
  return ask;
}

StepAsk step_no_pressure(const Landmarks& landmarks, Random& random) {
  if (random.one_in(2)) {
    // The spring pushes as hard as the damper pulls: k_z (p_z - z_zero) = 1024 N and d_z w_z = -1024 N.
    StepAsk ask = at_rest_with_force({16, -8, 1024}, {0, 0, -1}, landmarks, random);
    ask.wheel.d_z = -std::ldexp(1.0, static_cast<int>(random.between(4, 12)));
    ask.frame.velocity_in_world = rotated(ask.frame.world_from_wheel, {0, 0, 1024 / ask.wheel.d_z});
    return ask;
  }
  const RationalNormal& surface = pick_rational_normal(random);
  const Vector across{random.dyadic(-4, 4, 0), random.dyadic(-4, 4, 0), 0};
  StepAsk ask =
      at_rest_with_force(force_of_surface_force(surface, across), surface.normal, landmarks, random);
  ask.brake = random.one_in(2) ? 0 : random.dyadic(0, 1000, 0);
  return ask;
}

StepAsk step_z_limits(const Landmarks& landmarks, Random& random) {
  StepAsk ask = step_border(landmarks, random);
  const Wheel& wheel = ask.wheel;
  const Vector z_limits{wheel.z_min, wheel.z_zero, wheel.z_max};
  const double z = random.pick(z_limits);
  const auto& contact = std::get<Contact>(ask.state);
  const Vector pebble_in_wheel{random.dyadic(-1, 1, 4), random.dyadic(-1, 1, 4), z};
  ask.frame = frame_with(ask.frame.world_from_wheel, pebble_in_wheel, contact.pebble_in_world);
  return ask;
}

StepAsk step_steepness_limit(const Landmarks& landmarks, Random& random) {
  if (random.one_in(2)) {
    // Turned by the angle of 3-4-5: over level ground n = (0, +-4/5, -3/5) or (-+4/5, 0, -3/5) in wheel
    // coordinates.
    StepAsk ask = step_free_limits(landmarks, random);
    const FacePoint place = foothold(landmarks, random);
    const Quaternion tilt =
        random.one_in(2) ? Quaternion{2, random.sign(), 0, 0} : Quaternion{2, 0, random.sign(), 0};
    ask.frame = frame_with(product({0, 1, 0, 0}, tilt), {0, 0, 0.625}, place.point);
    ask.wheel.min_uprightness = 0.75;
    return ask;
  }
  const double scale = random.dyadic(1, 16, 0);
  const double x = random.sign() * scale;
  const double y = random.sign() * scale;
  const double uprightness = std::ldexp(1.0, static_cast<int>(random.between(-6, 3)));
  const Vector normal_in_wheel{3 * x, 4 * y, -5 * scale * uprightness};
  StepAsk ask = at_rest_with_force({0, 1, 1024}, normal_in_wheel, landmarks, random);
  ask.wheel.min_uprightness = random.one_in(3) ? std::nextafter(uprightness, 8.0) : uprightness;
  return ask;
}

}  // namespace groundtruth::cases
