// Wheels that nobody should build.

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include <groundtruth/cases/step_flavours.hpp>
#include <groundtruth/cases/step_parts.hpp>
#include <groundtruth/cases/vector_arithmetic.hpp>

namespace groundtruth::cases {

StepAsk step_stiff(const Landmarks& landmarks, Random& random) {
  StepAsk ask = random.one_in(4) ? step_resting(landmarks, random) : step_skidding(landmarks, random);
  ask.wheel.k_xy = -random.magnitude(-10, 60);
  ask.wheel.k_z = -random.magnitude(-10, 60);
  ask.wheel.d_xy = -random.magnitude(-10, 60);
  ask.wheel.d_z = -random.magnitude(-10, 60);
  ask.h = random.magnitude(-60, 10);
  return ask;
}

StepAsk step_unknown_tyre(const Landmarks& landmarks, Random& random) {
  StepAsk ask = random.one_in(2) ? step_free_hit(landmarks, random) : step_skidding(landmarks, random);
  constexpr std::array tyres{"wood", "Rubber", "rubber2"};
  ask.wheel.tyre = random.pick(tyres);
  return ask;
}

namespace {

// Any finite number of one sign. Zero only if asked for.
double any_size(Random& random) { return std::abs(bit_pattern_double(random)); }

double any_positive(Random& random) {
  const double size = any_size(random);
  return size > 0 ? size : 1;
}

Vector any_vector(Random& random) {
  return {bit_pattern_double(random), bit_pattern_double(random), bit_pattern_double(random)};
}

}  // namespace

StepAsk step_extreme_bits(const Landmarks& landmarks, Random& random) {
  StepAsk ask = random.one_in(2) ? step_free_hit(landmarks, random) : step_skidding(landmarks, random);
  Wheel& wheel = ask.wheel;
  if (random.one_in(2)) {
    wheel.k_xy = -any_positive(random);
    wheel.k_z = -any_positive(random);
    wheel.d_xy = -any_size(random);
    wheel.d_z = -any_size(random);
  }
  if (random.one_in(4)) wheel.min_uprightness = any_positive(random);
  if (random.one_in(4)) ask.brake = any_size(random);
  if (random.one_in(4)) ask.h = any_positive(random);
  if (random.one_in(4)) ask.frame.velocity_in_world = any_vector(random);
  if (random.one_in(4)) ask.frame.angular_velocity_in_world = any_vector(random);
  if (random.one_in(8)) ask.frame.position_in_world = any_vector(random);
  if (random.one_in(4)) {
    const double size = random.magnitude(-300, 300);
    for (double& component : ask.frame.world_from_wheel) component *= size;
  }
  if (auto* contact = std::get_if<Contact>(&ask.state)) {
    if (random.one_in(4)) contact->static_friction = any_size(random);
    if (random.one_in(4)) contact->dynamic_friction = any_size(random);
    if (random.one_in(4)) contact->maximum_force = any_size(random);
    if (random.one_in(4)) contact->pebble_velocity_in_world = any_vector(random);
    if (random.one_in(8)) contact->normal_in_world = any_vector(random);
  }
  return ask;
}

}  // namespace groundtruth::cases
