// What holds of every step, whatever its numbers.

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstring>

#include <groundtruth/tests/properties/generators.hpp>
#include <groundtruth/tests/properties/step_cases.hpp>

namespace groundtruth::properties {
namespace {

bool same_bits(const Vector& left, const Vector& right) {
  return std::memcmp(&left, &right, sizeof left) == 0;
}

RC_GTEST_PROP(StepLaw, AStuckPebbleStaysBitForBit, ()) {
  const StepCase c = *rc::gen::oneOf(lattice_steps(), wild_steps());
  const auto* before = std::get_if<Contact>(&c.ask.state);
  const StepAnswer answer = Ground(c.shape).step(c.ask);
  if (!before || outcome(answer) != "stick") return;
  const Contact& after = contact_of(answer);
  RC_ASSERT(same_bits(after.pebble_in_world, before->pebble_in_world));
  RC_ASSERT(same_bits(after.normal_in_world, before->normal_in_world));
  RC_ASSERT(same_bits(after.pebble_velocity_in_world, Vector{}));
  RC_ASSERT(after.static_friction == before->static_friction);
  RC_ASSERT(after.dynamic_friction == before->dynamic_friction);
  RC_ASSERT(after.maximum_force == before->maximum_force);
}

// And what does not slip does not depend on the scene.
RC_GTEST_PROP(StepLaw, OnlyMakingContactAndSlippingLookAtTheScene, ()) {
  const StepCase c = *lattice_steps();
  const StepCase other = *lattice_steps();
  if (std::holds_alternative<Free>(c.ask.state)) return;
  const StepAnswer answer = Ground(c.shape).step(c.ask);
  const StepAnswer elsewhere = Ground(other.shape).step(c.ask);
  if (outcome(answer) == "stick" || outcome(answer) == "surface_gave_way") RC_ASSERT(elsewhere == answer);
  const auto* stepped = std::get_if<Stepped>(&answer);
  const auto* stepped_elsewhere = std::get_if<Stepped>(&elsewhere);
  // The force of a slip is that of where it slipped from.
  if (stepped && stepped_elsewhere)
    RC_ASSERT(stepped->force_on_frame_in_world == stepped_elsewhere->force_on_frame_in_world);
}

// In an upright frame the step's own force is exact in doubles: what it bears is what the clip ask says.
RC_GTEST_PROP(StepLaw, TheForceOnTheFrameIsTheOppositeOfTheClippedForce, ()) {
  StepCase c = *lattice_steps();
  c.ask.frame.world_from_wheel = {1, 0, 0, 0};
  const auto* contact = std::get_if<Contact>(&c.ask.state);
  const StepAnswer answer = Ground(c.shape).step(c.ask);
  const auto* stepped = std::get_if<Stepped>(&answer);
  if (!contact || !stepped) return;
  const Wheel& wheel = c.ask.wheel;
  const Vector& omega = c.ask.frame.angular_velocity_in_world;
  Vector p, w;
  for (std::size_t i = 0; i < 3; ++i) p[i] = contact->pebble_in_world[i] - c.ask.frame.position_in_world[i];
  for (std::size_t i = 0; i < 3; ++i) {
    const double turning = omega[(i + 1) % 3] * p[(i + 2) % 3] - omega[(i + 2) % 3] * p[(i + 1) % 3];
    w[i] = contact->pebble_velocity_in_world[i] - c.ask.frame.velocity_in_world[i] - turning;
  }
  ClipAsk clipping;
  clipping.force_in_wheel = {wheel.k_xy * p[0] + wheel.d_xy * w[0], wheel.k_xy * p[1] + wheel.d_xy * w[1],
                             wheel.k_z * (p[2] - wheel.z_zero) + wheel.d_z * w[2]};
  clipping.normal_in_wheel = contact->normal_in_world;
  clipping.friction = contact->grip == Grip::stick ? contact->static_friction : contact->dynamic_friction;
  clipping.brake = c.ask.brake;
  clipping.min_uprightness = wheel.min_uprightness;
  const ClipAnswer clipped = clip(clipping);
  const Vector& n = clipping.normal_in_wheel;
  const Vector& f = clipping.force_in_wheel;
  const bool pressed = -(n[0] * f[0] + n[1] * f[1] + n[2] * f[2]) > 0;
  if (p[2] >= wheel.z_max || !pressed) {
    RC_ASSERT(answer == StepAnswer(Stepped({Free{}, {}})));
    return;
  }
  const auto& [grip, force] = std::get<Clipped>(clipped);
  RC_ASSERT((outcome(answer) == "stick") == (grip == Grip::stick));
  RC_ASSERT(stepped->force_on_frame_in_world == (Vector{-force[0], -force[1], -force[2]}));
}

// A free upright wheel asks for the entry point of its strut, and a landing is that.
RC_GTEST_PROP(StepLaw, AFreeWheelLandsAtTheEntryPointOfItsStrut, ()) {
  StepCase c = *lattice_steps();
  c.ask.state = Free{};
  c.ask.frame.world_from_wheel = {1, 0, 0, 0};
  const Wheel& wheel = c.ask.wheel;
  EntryAsk strut{c.ask.frame.position_in_world, c.ask.frame.position_in_world};
  strut.from[2] += wheel.z_min;
  strut.to[2] += wheel.z_max;
  const Ground ground(c.shape);
  const Entered entered = ground.entry(strut);
  const StepAnswer answer = ground.step(c.ask);
  if (entered.is_miss() || *entered.lambda == 1) {
    RC_ASSERT(answer == StepAnswer(Stepped({Free{}, {}})));
    return;
  }
  RC_ASSERT((outcome(answer) == "wheel_broken") == (*entered.lambda == 0));
  if (outcome(answer) != "stick") return;
  const Contact& made = contact_of(answer);
  RC_ASSERT(made.normal_in_world == entered.border().normal_in_world);
  RC_ASSERT(made.pebble_in_world[2] == static_cast<double>(point_at(strut, *entered.lambda)[2]));
  const Material& material = ground.scene().materials[entered.border().material.value()];
  RC_ASSERT(made.static_friction == material.friction_by_tyre.at(wheel.tyre).static_coefficient);
  RC_ASSERT(made.dynamic_friction == material.friction_by_tyre.at(wheel.tyre).dynamic_coefficient);
  RC_ASSERT(made.maximum_force == material.maximum_force);
}

// No answer bears -0.
RC_GTEST_PROP(StepLaw, NoZeroOfAForceIsNegative, ()) {
  const StepAnswer answer = [] {
    const StepCase c = *lattice_steps();
    return Ground(c.shape).step(c.ask);
  }();
  if (!std::holds_alternative<Stepped>(answer)) return;
  for (const double f : force_of(answer)) RC_ASSERT(f != 0 || !std::signbit(f));
}

}  // namespace
}  // namespace groundtruth::properties
