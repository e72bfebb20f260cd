// SPEC section 5: every state against every outcome it can have, and what comes first where several would
// apply.

#include <gtest/gtest.h>

#include <groundtruth/tests/properties/step_cases.hpp>

namespace groundtruth::properties {
namespace {

const Shape nothing{Nothing{}};
const Shape level = ground_at(1);
const Shape wall = covered(0, half_space(-1, 0, 0, 1));  // {x >= -1}
// An overhang, too steep for standing on it, that the strut at x = 0 meets at depth 1.
const Shape overhang = covered(0, all_of({half_space(-20, 0, -1, -1)}));

TEST(StepStates, FromFree) {
  const StepAsk ask = plain_step(Free{});
  EXPECT_EQ(outcome(nothing, ask), "free");
  EXPECT_EQ(outcome(ground_at(3), ask), "free");
  EXPECT_EQ(outcome(level, ask), "stick");
  EXPECT_EQ(outcome(ground_at(-1), ask), "wheel_broken");
  EXPECT_EQ(outcome(wall, ask), "wheel_broken");
  EXPECT_EQ(outcome(overhang, ask), "surface_too_steep");
  EXPECT_EQ(outcome(half_space(0, 0, -1, -1), ask), "refusal");
  EXPECT_EQ(outcome(ground_at(1, 1), ask), "refusal");
  const StepAnswer stuck = Ground(level).step(ask);
  EXPECT_EQ(
      stuck,
      StepAnswer(Stepped({Contact{Grip::stick, {0, 0, 1}, {}, {0, 0, -1}, 0.5, 0.375, std::nullopt}, {}})));
}

class StepFromContact : public ::testing::TestWithParam<Grip> {
 protected:
  static StepAsk at(const Vector& pebble) { return plain_step(contact(GetParam(), pebble)); }
};
INSTANTIATE_TEST_SUITE_P(StickAndSlip, StepFromContact, ::testing::Values(Grip::stick, Grip::slip),
                         [](const auto& grip) { return grip.param == Grip::stick ? "Stick" : "Slip"; });

TEST_P(StepFromContact, WithoutSlippingNeedsNoScene) {
  EXPECT_EQ(outcome(nothing, at({0, 0, 3})), "free");
  EXPECT_EQ(outcome(nothing, at({0, 0, -1})), "wheel_broken");
  EXPECT_EQ(outcome(nothing, at({0.125, 0, 1})), "stick");
  StepAsk steep = at({0, 0, 1});
  std::get<Contact>(steep.state).normal_in_world = {20, 0, -1};
  EXPECT_EQ(outcome(nothing, steep), "surface_too_steep");
  StepAsk weak = at({0, 0, 1});
  std::get<Contact>(weak.state).maximum_force = 3;
  EXPECT_EQ(outcome(nothing, weak), "surface_gave_way");
  StepAsk pulled = at({0, 0, 1});
  pulled.wheel.d_z = -1;
  pulled.frame.velocity_in_world = {0, 0,
                                    -5};  // it rises: the damper pulls with 5 N, the spring presses with 4 N
  EXPECT_EQ(outcome(nothing, pulled), "free");
  EXPECT_EQ(force_of(Ground(nothing).step(pulled)), Vector{});
}

TEST_P(StepFromContact, SlippingFindsTheGroundWhereThePebbleGoes) {
  const StepAsk ask = at({3, 0, 1});  // 12 N against at most 2 N
  EXPECT_EQ(outcome(level, ask), "slip");
  EXPECT_EQ(outcome(nothing, ask), "free");
  EXPECT_EQ(outcome(ground_at(2), ask), "free");
  EXPECT_EQ(outcome(ground_at(0), ask), "wheel_broken");
  EXPECT_EQ(outcome(covered(0, half_space(-20, 0, -1, -1)), at({0, 3, 1})), "surface_too_steep");
  EXPECT_EQ(outcome(half_space(0, 0, -1, -1), ask), "refusal");
  EXPECT_EQ(outcome(ground_at(1, 1), ask), "refusal");
}

TEST_P(StepFromContact, WhereThePebbleFindsNoGroundTheForceIsStillTheClippedOne) {
  const double held = GetParam() == Grip::stick ? 2 : 1;
  for (const Shape& shape : {nothing, ground_at(2), level})
    EXPECT_EQ(force_of(Ground(shape).step(at({3, 0, 1}))), (Vector{held, 0, -4}));
}

TEST_P(StepFromContact, TheNewContactIsOfTheGroundItFinds) {
  const Shape ice_beyond = painted(3, half_space(1, 0, 0, 1), level);
  const StepAnswer answer = Ground(ice_beyond).step(at({3, 0, 1}));
  const double x = GetParam() == Grip::stick ? 0.5 : 0.25;
  EXPECT_EQ(contact_of(answer),
            (Contact{Grip::slip, {x, 0, 1}, {(x - 3) / 0.5, 0, 0}, {0, 0, -1}, 0.25, 0, std::nullopt}));
}

// The order of SPEC section 5: lift-off, broken, steep, tension, gave way, clip.
TEST_P(StepFromContact, WhatComesFirstDecides) {
  StepAsk ask = at({9, 9, 2});
  Contact& contact = std::get<Contact>(ask.state);
  contact.normal_in_world = {0, 0, 1};
  contact.maximum_force = 0;
  EXPECT_EQ(outcome(nothing, ask), "free");
  contact.pebble_in_world[2] = 0;
  EXPECT_EQ(outcome(nothing, ask), "wheel_broken");
  contact.pebble_in_world[2] = 1;
  EXPECT_EQ(outcome(nothing, ask), "surface_too_steep");
  contact.normal_in_world = {0, 0, -1};
  EXPECT_EQ(outcome(nothing, ask), "surface_gave_way");
  ask.wheel.d_z = -1;
  ask.frame.velocity_in_world = {0, 0, -4};
  EXPECT_EQ(outcome(nothing, ask), "free");
}

// Of a landing: miss and lambda = 1, lambda = 0, steep, material.
TEST(StepStates, WhatComesFirstAtALandingDecides) {
  const StepAsk ask = plain_step(Free{});
  EXPECT_EQ(outcome(half_space(0, 0, -1, -2), ask), "free");
  EXPECT_EQ(outcome(half_space(1, 0, 0, 0), ask), "wheel_broken");
  EXPECT_EQ(outcome(half_space(-20, 0, -1, -1), ask), "surface_too_steep");
  EXPECT_EQ(outcome({Everything{}}, ask), "wheel_broken");
}

// Two faces of one point: the canonical leaf's material and steepness, not the other's.
TEST(StepStates, TheContactIsThatOfTheCanonicalLeaf) {
  const Shape soft_ramp = covered(2, half_space(1, 0, -1, -1));
  EXPECT_EQ(contact_of(Ground(any_of({level, soft_ramp})).step(plain_step(Free{}))).maximum_force,
            std::nullopt);
  EXPECT_EQ(contact_of(Ground(any_of({soft_ramp, level})).step(plain_step(Free{}))).maximum_force, 6.0);
  EXPECT_EQ(outcome(any_of({half_space(0, 0, -1, -1), level}), plain_step(Free{})), "refusal");
  EXPECT_EQ(outcome(any_of({level, half_space(0, 0, -1, -1)}), plain_step(Free{})), "stick");
}

}  // namespace
}  // namespace groundtruth::properties
