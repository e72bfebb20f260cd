// Every boundary of SPEC section 5, hit with equality, and missed by one ulp on the side where equality makes
// a difference.

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <groundtruth/tests/properties/step_cases.hpp>

namespace groundtruth::properties {
namespace {

double above(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }
double below(double x) { return std::nextafter(x, -std::numeric_limits<double>::infinity()); }

const Shape nothing{Nothing{}};

class StepBorders : public ::testing::TestWithParam<Grip> {
 protected:
  static StepAsk at(const Vector& pebble) { return plain_step(contact(GetParam(), pebble)); }
  // Of a contact of this grip.
  static double friction() { return GetParam() == Grip::stick ? 0.5 : 0.25; }
};
INSTANTIATE_TEST_SUITE_P(StickAndSlip, StepBorders, ::testing::Values(Grip::stick, Grip::slip),
                         [](const auto& grip) { return grip.param == Grip::stick ? "Stick" : "Slip"; });

TEST_P(StepBorders, AtZMaxItIsFree) {
  EXPECT_EQ(outcome(nothing, at({0, 0, 2})), "free");
  EXPECT_EQ(outcome(nothing, at({0, 0, below(2)})), "stick");
  // Even if the damper presses.
  StepAsk falling = at({0, 0, 2});
  falling.wheel.d_z = -1;
  falling.frame.velocity_in_world = {0, 0, 1};
  EXPECT_EQ(outcome(nothing, falling), "free");
  std::get<Contact>(falling.state).pebble_in_world[2] = below(2);
  EXPECT_EQ(outcome(nothing, falling), "stick");
}

TEST_P(StepBorders, AtZMinTheWheelIsBroken) {
  EXPECT_EQ(outcome(nothing, at({0, 0, 0})), "wheel_broken");
  EXPECT_EQ(outcome(nothing, at({0, 0, above(0)})), "stick");
}

// Between z_zero and z_max nothing presses.
TEST_P(StepBorders, AtZZeroItIsFree) {
  StepAsk ask = at({0, 0, 1});
  ask.wheel.z_zero = 1;
  EXPECT_EQ(outcome(nothing, ask), "free");
  std::get<Contact>(ask.state).pebble_in_world[2] = below(1);
  EXPECT_EQ(outcome(nothing, ask), "stick");
  std::get<Contact>(ask.state).pebble_in_world[2] = 1.5;
  EXPECT_EQ(outcome(nothing, ask), "free");
}

// On the surface with normal (3, 0, -4), 5 F'_z = -3 F_x + 4 F_z.
TEST_P(StepBorders, WhereNothingPressesOnASlopeItIsFree) {
  StepAsk ask = at({0, 0, 1});
  Contact& contact = std::get<Contact>(ask.state);
  contact.normal_in_world = {3, 0, -4};
  ask.wheel.k_xy = -3;
  ask.wheel.k_z = -9;
  contact.static_friction = contact.dynamic_friction = 0x1p100;
  ask.brake = 1000;
  contact.pebble_in_world = {-4, 0, 1};  // F = (12, 0, 9)
  EXPECT_EQ(outcome(nothing, ask), "free");
  contact.pebble_in_world[0] = above(-4);
  EXPECT_EQ(outcome(nothing, ask), "stick");
}

TEST_P(StepBorders, TheMaximumForceIsBorne) {
  StepAsk ask = at({0, 0, 1});
  auto& maximum_force = std::get<Contact>(ask.state).maximum_force;
  maximum_force = 4;
  EXPECT_EQ(outcome(nothing, ask), "stick");
  maximum_force = below(4);
  EXPECT_EQ(outcome(nothing, ask), "surface_gave_way");
  std::get<Contact>(ask.state).normal_in_world = {3, 0, -4};  // F'_z = 16 / 5, of which the double is greater
  std::get<Contact>(ask.state).static_friction = std::get<Contact>(ask.state).dynamic_friction = 1;
  maximum_force = 3.2;
  EXPECT_EQ(outcome(nothing, ask), "stick");
  maximum_force = below(3.2);
  EXPECT_EQ(outcome(nothing, ask), "surface_gave_way");
  maximum_force = 0;
  EXPECT_EQ(outcome(nothing, ask), "surface_gave_way");
}

TEST_P(StepBorders, OnTheDiscItSticks) {
  const double most = friction();  // metres: 4 N/m against friction * 4 N
  EXPECT_EQ(outcome(nothing, at({most, 0, 1})), "stick");
  EXPECT_EQ(outcome(ground_at(1), at({above(most), 0, 1})), "slip");
  EXPECT_EQ(outcome(ground_at(1), at({0, -above(most), 1})), "slip");
  EXPECT_EQ(outcome(ground_at(1), at({most, above(0), 1})), "slip");
  StepAsk diagonal = at({-0.75, 1, 1});  // 3 N and 4 N against 5 N
  std::get<Contact>(diagonal.state).static_friction = std::get<Contact>(diagonal.state).dynamic_friction =
      1.25;
  EXPECT_EQ(outcome(nothing, diagonal), "stick");
  std::get<Contact>(diagonal.state).pebble_in_world[1] = above(1);
  EXPECT_EQ(outcome(ground_at(1), diagonal), "slip");
}

TEST_P(StepBorders, OnTheBandItSticks) {
  StepAsk ask = at({0.125, 0, 1});
  ask.brake = 0.5;
  EXPECT_EQ(outcome(nothing, ask), "stick");
  ask.brake = below(0.5);
  EXPECT_EQ(outcome(ground_at(1), ask), "slip");
  ask.brake = 0;
  std::get<Contact>(ask.state).pebble_in_world = {0, 0.125, 1};
  EXPECT_EQ(outcome(nothing, ask), "stick");
}

TEST_P(StepBorders, WhereTheNormalIsJustUprightItHolds) {
  StepAsk ask = at({0, 0, 1});
  ask.wheel.min_uprightness = 1;
  Vector& normal = std::get<Contact>(ask.state).normal_in_world;
  std::get<Contact>(ask.state).static_friction = std::get<Contact>(ask.state).dynamic_friction = 2;
  normal = {3, 4, -5};
  EXPECT_EQ(outcome(nothing, ask), "stick");
  normal = {3, 4, above(-5)};
  EXPECT_EQ(outcome(nothing, ask), "surface_too_steep");
}

TEST_P(StepBorders, ASlipThatFindsGroundAtTheVeryEndsOfItsStrut) {
  const StepAsk ask = at({3, 0, 1});
  EXPECT_EQ(outcome(ground_at(0), ask), "wheel_broken");
  EXPECT_EQ(outcome(ground_at(above(0)), ask), "slip");
  EXPECT_EQ(outcome(ground_at(below(2)), ask), "slip");
  EXPECT_EQ(outcome(ground_at(2), ask), "free");
}

// The new pebble, at x = friction, meets the kerb's face only if the kerb reaches as far.
TEST_P(StepBorders, ASlipOntoTheVeryEdgeOfAKerb) {
  const double x = friction();
  const auto kerb = [](double first_x) { return covered(0, box({first_x, -1, 1}, {9, 1, 9})); };
  EXPECT_EQ(outcome(kerb(x), at({3, 0, 1})), "slip");
  EXPECT_EQ(outcome(kerb(above(x)), at({3, 0, 1})), "free");
}

TEST(StepBordersFromFree, GroundAtTheVeryEndsOfTheStrut) {
  const StepAsk ask = plain_step(Free{});
  EXPECT_EQ(outcome(ground_at(0), ask), "wheel_broken");
  EXPECT_EQ(outcome(ground_at(above(0)), ask), "stick");
  EXPECT_EQ(outcome(ground_at(below(2)), ask), "stick");
  EXPECT_EQ(outcome(ground_at(2), ask), "free");
  EXPECT_EQ(outcome(ground_at(above(2)), ask), "free");
}

TEST(StepBordersFromFree, ASlopeThatIsJustUpright) {
  StepAsk ask = plain_step(Free{});
  ask.wheel.min_uprightness = 0.75;
  EXPECT_EQ(outcome(covered(0, half_space(4, 0, -3, -3)), ask), "stick");
  EXPECT_EQ(outcome(covered(0, half_space(above(4), 0, -3, -3)), ask), "surface_too_steep");
}

}  // namespace
}  // namespace groundtruth::properties
