// Where a slipping pebble goes: the two rules of SPEC section 5.

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <groundtruth/tests/properties/generators.hpp>
#include <groundtruth/tests/properties/step_cases.hpp>

namespace groundtruth::properties {
namespace {

// On level ground 1 m down, with d_xy = -2 N s/m; h = 0.5 s.
StepAsk damped(Relocation relocation, const Vector& pebble, const Vector& velocity) {
  StepAsk ask = plain_step(contact(Grip::slip, pebble));
  ask.wheel.relocation = relocation;
  ask.wheel.d_xy = -2;
  std::get<Contact>(ask.state).pebble_velocity_in_world = velocity;
  std::get<Contact>(ask.state).dynamic_friction = 2.5;
  return ask;
}

TEST(StepRelocation, TheSpringRulePutsThePebbleWhereTheSpringAloneGivesTheClippedForce) {
  // F = (-4 * 3 - 2 * 0, -4 * 4, 4), clipped to 10 N: (-6, -8).
  const StepAnswer answer = Ground(ground_at(1)).step(damped(Relocation::spring, {3, 4, 1}, {}));
  EXPECT_EQ(force_of(answer), (Vector{6, 8, -4}));
  EXPECT_EQ(contact_of(answer).pebble_in_world, (Vector{1.5, 2, 1}));
  EXPECT_EQ(contact_of(answer).pebble_velocity_in_world, (Vector{-3, -4, 0}));
}

TEST(StepRelocation, TheReturnMappingPutsItWhereSpringAndDamperGiveTheClippedForce) {
  // k + d/h = -8: (x, y) = ((-6, -8) - 4 (3, 4)) / -8. Its velocity (p_new - p) / h with the spring at p_new
  // gives -4 * 2.25 - 2 * -1.5 = -6.
  const StepAnswer answer = Ground(ground_at(1)).step(damped(Relocation::return_mapping, {3, 4, 1}, {}));
  EXPECT_EQ(force_of(answer), (Vector{6, 8, -4}));
  EXPECT_EQ(contact_of(answer).pebble_in_world, (Vector{2.25, 3, 1}));
  EXPECT_EQ(contact_of(answer).pebble_velocity_in_world, (Vector{-1.5, -2, 0}));
}

RC_GTEST_PROP(StepRelocation, WithoutDampingBothRulesAreOne, ()) {
  StepCase c = *rc::gen::oneOf(lattice_steps(), wild_steps());
  c.ask.wheel.d_xy = 0;
  c.ask.wheel.relocation = Relocation::spring;
  StepCase other = c;
  other.ask.wheel.relocation = Relocation::return_mapping;
  const StepAnswer one = Ground(c.shape).step(c.ask);
  const StepAnswer two = Ground(other.shape).step(other.ask);
  RC_ASSERT(outcome(one) == outcome(two));
  if (outcome(one) != "refusal") RC_ASSERT(one == two);
}

// On level ground, with the force a hair beyond the border, the pebble moves by a hair.
RC_GTEST_PROP(StepRelocation, TheReturnMappingIsContinuousWhereStickMeetsSlip, ()) {
  const double x = *rc::gen::inRange(-8, 9) / 2.0, y = *rc::gen::inRange(-8, 9) / 2.0;
  const double v = *rc::gen::inRange(-4, 5), w = *rc::gen::inRange(-4, 5);
  StepAsk ask = damped(Relocation::return_mapping, {x, y, 1}, {v, w, 0});
  const double fx = -4 * x - 2 * v, fy = -4 * y - 2 * w;
  const double hair = 0x1p-40;
  // The band, cut a hair inside of the force; then the disc.
  if (fx != 0) {
    std::get<Contact>(ask.state).dynamic_friction = 1000;
    ask.brake = std::fabs(fx);
    RC_ASSERT(outcome(ground_at(1), ask) == "stick");
    ask.brake -= hair;
    const StepAnswer slipped = Ground(ground_at(1)).step(ask);
    RC_ASSERT(outcome(slipped) == "slip");
    RC_ASSERT(std::fabs(contact_of(slipped).pebble_in_world[0] - x) <= hair);
    RC_ASSERT(contact_of(slipped).pebble_in_world[1] == y);
  }
  ask.brake = 1000;
  const double size = std::hypot(fx, fy);
  if (size == 0) return;
  std::get<Contact>(ask.state).dynamic_friction = size / 4 - hair;  // N = 4
  const StepAnswer slipped = Ground(ground_at(1)).step(ask);
  RC_ASSERT(outcome(slipped) == "slip");
  for (std::size_t i = 0; i < 2; ++i) {
    const double before = i == 0 ? x : y;
    RC_ASSERT(std::fabs(contact_of(slipped).pebble_in_world[i] - before) <= 4 * hair);
  }
}

// What it cures: 2 m/s at d = -2 is a jump of d w / k = 1 m.
TEST(StepRelocation, TheSpringRuleJumpsWhereStickMeetsSlip) {
  StepAsk ask = damped(Relocation::spring, {1, 0, 1}, {2, 0, 0});
  ask.brake = std::nextafter(8.0, 0.0);
  const StepAnswer slipped = Ground(ground_at(1)).step(ask);
  EXPECT_NEAR(contact_of(slipped).pebble_in_world[0], 2, 1e-12);
  ask.wheel.relocation = Relocation::return_mapping;
  EXPECT_NEAR(contact_of(Ground(ground_at(1)).step(ask)).pebble_in_world[0], 1, 1e-12);
}

// A slip without brake keeps the pebble's y, and its x goes where the spring is slack: at once, or by the
// damper's leave.
TEST(StepRelocation, WithoutBrakeTheWheelRollsFreely) {
  StepAsk ask = damped(Relocation::spring, {3, 0, 1}, {});
  ask.brake = 0;
  EXPECT_EQ(contact_of(Ground(ground_at(1)).step(ask)).pebble_in_world, (Vector{0, 0, 1}));
  EXPECT_EQ(force_of(Ground(ground_at(1)).step(ask)), (Vector{0, 0, -4}));
  ask.wheel.relocation = Relocation::return_mapping;
  EXPECT_EQ(contact_of(Ground(ground_at(1)).step(ask)).pebble_in_world, (Vector{1.5, 0, 1}));
}

}  // namespace
}  // namespace groundtruth::properties
