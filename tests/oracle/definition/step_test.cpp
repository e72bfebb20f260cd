#include <cmath>

#include <gtest/gtest.h>

#include <groundtruth/definition/step.hpp>

#include "shapes.hpp"

namespace groundtruth::definition {
namespace {

using namespace test;

// z points up; the ground's top is z = 0; the frame is the world turned by half a turn about x: wheel z is
// down.
const Quaternion upright{0, 1, 0, 0};

groundtruth::Scene world(Shape shape) {
  return {{{"tar", {{"rubber", {0.5, 0.25}}}, 1000.0}, {"ice", {{"metal", {0.125, 0.125}}}, std::nullopt}},
          std::move(shape)};
}

const Shape tar_plane = made_of(0, half_space(0, 0, 1, 0));

StepAsk resting_ask() {
  StepAsk ask;
  ask.wheel = {-100, -100, -10, -10, 0.25, 0.75, 0.75, "rubber", 0.1, Relocation::spring};
  ask.frame.position_in_world = {0, 0, 0.5};
  ask.frame.world_from_wheel = upright;
  ask.brake = 5;
  ask.h = 0.5;
  return ask;
}

// Of a pebble at this place of the world; with the frame of `resting_ask` the pressing force is 25 N.
Contact pebble_at(double x, double y, Grip grip = Grip::stick) {
  return {grip, {x, y, 0}, {0, 0, 0}, {0, 0, 1}, 0.5, 0.25, 1000.0};
}

StepAsk ask_with(const Contact& contact) {
  StepAsk ask = resting_ask();
  ask.state = contact;
  return ask;
}

StepAnswer answer_to(const StepAsk& ask, const Shape& shape = tar_plane) {
  return step(Scene(world(shape)), ask);
}

Contact contact_of(const StepAnswer& answer) { return std::get<Contact>(std::get<Stepped>(answer).state); }
Vector force_of(const StepAnswer& answer) { return std::get<Stepped>(answer).force_on_frame_in_world; }
bool is_free(const StepAnswer& answer) {
  const auto* stepped = std::get_if<Stepped>(&answer);
  return stepped && std::holds_alternative<Free>(stepped->state);
}
std::string refusal(const StepAnswer& answer) {
  const auto* refused = std::get_if<Refusal>(&answer);
  return refused ? refused->reason : "not refused";
}

const StepAnswer broken = StepFailure::wheel_broken;
const StepAnswer too_steep = StepFailure::surface_too_steep;
const StepAnswer gave_way = StepFailure::surface_gave_way;

TEST(StepFromFree, PutsAStickingPebbleWhereTheLegMeetsTheGround) {
  StepAsk ask = resting_ask();
  ask.frame.position_in_world = {3, 4, 0.5};
  const StepAnswer answer = answer_to(ask);
  EXPECT_EQ(contact_of(answer), (Contact{Grip::stick, {3, 4, 0}, {0, 0, 0}, {0, 0, 1}, 0.5, 0.25, 1000.0}));
  EXPECT_EQ(force_of(answer), (Vector{0, 0, 0}));
}

TEST(StepFromFree, StaysFreeUntilTheLegReachesBelowTheSurface) {
  StepAsk ask = resting_ask();
  ask.frame.position_in_world[2] = 0.75;  // lambda = 1
  EXPECT_TRUE(is_free(answer_to(ask)));
  ask.frame.position_in_world[2] = std::nextafter(0.75, 0);
  EXPECT_FALSE(is_free(answer_to(ask)));
  ask.frame.position_in_world[2] = 9;
  EXPECT_TRUE(is_free(answer_to(ask)));
}

TEST(StepFromFree, BreaksWhereTheLegStartsInTheGround) {
  StepAsk ask = resting_ask();
  ask.frame.position_in_world[2] = 0.25;  // lambda = 0, on the border
  EXPECT_EQ(answer_to(ask), broken);
  ask.frame.position_in_world[2] = 0;  // inside
  EXPECT_EQ(answer_to(ask), broken);
}

TEST(StepFromFree, FindsSteepnessBeforeItMissesTheMaterial) {
  const Shape wall = half_space(20, 0, 1, 0);
  EXPECT_EQ(answer_to(resting_ask(), wall), too_steep);
  EXPECT_EQ(refusal(answer_to(resting_ask(), half_space(0, 0, 1, 0))), "contact: leaf 0 has no material");
}

TEST(StepFromFree, RefusesATyreThatTheMaterialDoesNotKnow) {
  const std::string reason =
      refusal(answer_to(resting_ask(), any_of({half_space(1, 0, 0, -9), made_of(1, tar_plane)})));
  EXPECT_EQ(reason, "contact: leaf 1: material 'ice' has no friction for 'rubber'");
}

TEST(StepInStick, HoldsThePebbleToTheLastBit) {
  const StepAnswer answer = answer_to(ask_with(pebble_at(0.03125, -0.0625)));
  EXPECT_EQ(contact_of(answer), pebble_at(0.03125, -0.0625));
  // Pressing 25 N, so the disc's radius is 12.5 N. On the frame: towards the pebble, and up.
  EXPECT_EQ(force_of(answer), (Vector{3.125, -6.25, 25}));
}

TEST(StepInStick, ForgetsTheVelocityOfThePebble) {
  Contact contact = pebble_at(0, 0);
  contact.pebble_velocity_in_world = {0.25, 0, 0};
  const StepAnswer answer = answer_to(ask_with(contact));
  EXPECT_EQ(contact_of(answer).pebble_velocity_in_world, (Vector{0, 0, 0}));
  EXPECT_EQ(force_of(answer), (Vector{2.5, 0, 25}));  // -F with F_x = d_xy w_x
}

TEST(StepInStick, DampsTheVelocityOfTheTurningFrame) {
  StepAsk ask = ask_with(pebble_at(0.03125, 0));
  ask.frame.velocity_in_world = {0, 0.5, -0.25};
  ask.frame.angular_velocity_in_world = {0, 0, 2};
  // p_t - b = (0.03125, 0, -0.5), omega x it = (0, 0.0625, 0); w in world (0, -0.5625, 0.25), in wheel
  // (0, 0.5625, -0.25). F = (-3.125, -5.625, 25 + 2.5).
  EXPECT_EQ(force_of(answer_to(ask)), (Vector{3.125, -5.625, 27.5}));
}

TEST(StepInStick, UsesStaticFrictionAndSlipsWithDynamic) {
  const double reach = 0.1;  // 10 N sideways: above 0.25 * 25, below 0.5 * 25
  EXPECT_EQ(contact_of(answer_to(ask_with(pebble_at(0, reach)))).grip, Grip::stick);
  EXPECT_EQ(contact_of(answer_to(ask_with(pebble_at(0, reach, Grip::slip)))).grip, Grip::slip);
}

TEST(StepInContact, LiftsOffAtZMaxBeforeAllElse) {
  Contact contact = pebble_at(0, 0);
  contact.normal_in_world = {1, 0, 0};
  StepAsk ask = ask_with(contact);
  ask.frame.position_in_world[2] = 0.75;
  EXPECT_TRUE(is_free(answer_to(ask)));
  EXPECT_EQ(force_of(answer_to(ask)), (Vector{0, 0, 0}));
  ask.frame.position_in_world[2] = 0.25;
  EXPECT_EQ(answer_to(ask), broken);
  ask.frame.position_in_world[2] = 0.5;
  EXPECT_EQ(answer_to(ask), too_steep);
}

TEST(StepInContact, LetsGoWhereNothingPresses) {
  StepAsk ask = ask_with(pebble_at(0.03125, 0));
  ask.frame.velocity_in_world = {0, 0, 2.5};  // the damper takes all of the 25 N
  EXPECT_TRUE(is_free(answer_to(ask)));
  EXPECT_EQ(force_of(answer_to(ask)), (Vector{0, 0, 0}));
  ask.frame.velocity_in_world[2] = std::nextafter(2.5, 0);
  EXPECT_FALSE(is_free(answer_to(ask)));
}

TEST(StepInContact, GivesWayAboveTheMaximumForceOnly) {
  Contact contact = pebble_at(0, 0);
  contact.maximum_force = 25;
  EXPECT_EQ(contact_of(answer_to(ask_with(contact))).grip, Grip::stick);
  contact.maximum_force = std::nextafter(25.0, 0);
  EXPECT_EQ(answer_to(ask_with(contact)), gave_way);
  contact.maximum_force.reset();
  EXPECT_EQ(contact_of(answer_to(ask_with(contact))).grip, Grip::stick);
}

TEST(StepInSlip, MovesThePebbleToWhereTheSpringGivesTheForce) {
  // 6.25 N against a brake of 5: F_cl = (-5, 0, 25), new x = 1/20, velocity (1/20 - 1/16) / h = -1/40.
  const StepAnswer answer = answer_to(ask_with(pebble_at(0.0625, 0)));
  EXPECT_EQ(force_of(answer), (Vector{5, 0, 25}));
  const Contact next = contact_of(answer);
  EXPECT_EQ(next.grip, Grip::slip);
  EXPECT_EQ(next.pebble_in_world, (Vector{0.05, 0, 0}));
  EXPECT_EQ(next.pebble_velocity_in_world, (Vector{-0.025, 0, 0}));
}

TEST(StepInSlip, ByReturnMappingWeighsInTheDamper) {
  StepAsk ask = ask_with(pebble_at(0.0625, 0, Grip::slip));
  ask.wheel.relocation = Relocation::return_mapping;
  ask.frame.velocity_in_world = {-0.25, 0, 0};
  // w_x = 0.25: F_x = -6.25 - 2.5 = -8.75, clipped to -5. d/h = -20:
  // x = (-5 - 20 * 0.0625 + 10 * 0.25) / (-100 - 20) = 3.75 / 120 = 1/32.
  const StepAnswer answer = answer_to(ask);
  EXPECT_EQ(force_of(answer), (Vector{5, 0, 25}));
  EXPECT_EQ(contact_of(answer).pebble_in_world, (Vector{0.03125, 0, 0}));
  EXPECT_EQ(contact_of(answer).pebble_velocity_in_world, (Vector{-0.0625, 0, 0}));
}

TEST(StepInSlip, ReachesAnIrrationalPlaceCorrectlyRounded) {
  // F_xy = -100 (1, 1) is clipped to the rim of the disc, radius 6.25: x = y = 0.0625 / sqrt 2.
  StepAsk ask = ask_with(pebble_at(1, -1, Grip::slip));
  ask.brake = 100;
  const StepAnswer answer = answer_to(ask);
  const double place = 0.0625 * std::sqrt(0.5);
  EXPECT_EQ(contact_of(answer).pebble_in_world, (Vector{place, -place, 0}));
  const double sideways = std::sqrt(19.53125);  // 6.25 / sqrt 2
  EXPECT_EQ(force_of(answer), (Vector{sideways, -sideways, 25}));
}

TEST(StepInSlip, DecidesAtAnIrrationalPlaceExactly) {
  // As above, but the tar ends at x = place; the pebble's x is below it or not by the last bit only.
  StepAsk ask = ask_with(pebble_at(1, -1, Grip::slip));
  ask.brake = 100;
  const double place = 0.0625 * std::sqrt(0.5);
  ASSERT_GT(std::fma(place, 512 * place, -1), 0) << "sqrt(0.5) is rounded up";
  const auto tar_up_to = [](double x) { return all_of({tar_plane, half_space(1, 0, 0, x)}); };
  EXPECT_FALSE(is_free(answer_to(ask, tar_up_to(place))));
  EXPECT_TRUE(is_free(answer_to(ask, tar_up_to(std::nextafter(place, 0)))));
}

TEST(StepInSlip, OverAnEdgeIsFreeButKeepsItsForceThisOnce) {
  const Shape cliff = all_of({tar_plane, half_space(1, 0, 0, 0)});
  const StepAnswer answer = answer_to(ask_with(pebble_at(0.075, 0)), cliff);
  EXPECT_TRUE(is_free(answer));
  EXPECT_EQ(force_of(answer), (Vector{5, 0, 25}));
}

TEST(StepInSlip, LandsOnWhatLiesThere) {
  const auto step_of_height = [](double height) {
    return any_of({tar_plane, made_of(0, box({-1, -1, -1}, {1, 1, height}))});
  };
  const StepAnswer onto = answer_to(ask_with(pebble_at(0.0625, 0)), step_of_height(0.125));
  EXPECT_EQ(contact_of(onto).pebble_in_world[2], 0.125);
  EXPECT_EQ(contact_of(onto).pebble_velocity_in_world[2], 0.25);
  EXPECT_EQ(answer_to(ask_with(pebble_at(0.0625, 0)), step_of_height(0.25)), broken);
  EXPECT_EQ(answer_to(ask_with(pebble_at(0.0625, 0)), half_space(20, 0, 1, 1)), too_steep);
  EXPECT_EQ(refusal(answer_to(ask_with(pebble_at(0.0625, 0)), half_space(0, 0, 1, 0))),
            "contact: leaf 0 has no material");
  EXPECT_EQ(refusal(answer_to(ask_with(pebble_at(0.0625, 0)), made_of(1, half_space(0, 0, 1, 0)))),
            "contact: leaf 0: material 'ice' has no friction for 'rubber'");
}

TEST(StepInSlip, RefusesAVelocityThatNoDoubleHolds) {
  StepAsk ask = ask_with(pebble_at(0.0625, 0));
  ask.h = 0x1p-1074;
  EXPECT_NE(refusal(answer_to(ask)).find("state.velocity[0]"), std::string::npos);
}

TEST(StepInStick, RefusesAForceThatNoDoubleHolds) {
  Contact contact = pebble_at(0, 0);
  contact.maximum_force.reset();
  StepAsk ask = ask_with(contact);
  ask.wheel.d_z = -1e200;
  ask.frame.velocity_in_world = {0, 0, -1e200};
  EXPECT_NE(refusal(answer_to(ask)).find("force[2]"), std::string::npos);
}

}  // namespace
}  // namespace groundtruth::definition
