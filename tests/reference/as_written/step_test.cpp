#include <groundtruth/as_written/step.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "shapes.hpp"

namespace groundtruth::as_written {
namespace {

const Errata none{};

// The world's z points up; this turns the wheel's z down.
const Quaternion upright{0, 1, 0, 0};

// Dry ground below z = 0.
const Scene& ground() {
  static const Scene scene{{{{"dry", {{"rubber", {0.5, 0.25}}}, 1e7}}, covered(0, half_space({0, 0, 1}, 0))}};
  return scene;
}

Wheel soft_wheel() { return {-1000, -10000, -100, -500, 0.25, 0.75, 0.75, "rubber"}; }

// The frame 0.5 m above the ground: the springs are pressed 0.25 m and push with 2500 N.
StepAsk pressed() {
  StepAsk ask;
  ask.wheel = soft_wheel();
  ask.frame.position_in_world = {0, 0, 0.5};
  ask.frame.world_from_wheel = upright;
  ask.brake = 1e4;
  ask.h = 0.01;
  ask.state = Contact{Grip::stick, {0, 0, 0}, {0, 0, 0}, {0, 0, 1}, 0.5, 0.25, 1e7};
  return ask;
}

const Stepped& stepped(const StepAnswer& answer) { return std::get<Stepped>(answer); }
const Contact& contact(const StepAnswer& answer) { return std::get<Contact>(stepped(answer).state); }

// Drops 100 kg on one wheel; says how the last step went.
StepAnswer drop(const Errata& errata) {
  const double mass = 100;
  StepAsk ask = pressed();
  ask.h = 0.001;
  ask.frame.position_in_world[2] = 0.8;
  ask.state = Free{};
  StepAnswer answer = Stepped{};
  for (int i = 0; i < 3000; ++i) {
    answer = step(ground(), ask, errata);
    if (!std::holds_alternative<Stepped>(answer)) {
      return answer;
    }
    ask.state = stepped(answer).state;
    const double force_up = stepped(answer).force_on_frame_in_world[2] - 9.81 * mass;
    ask.frame.velocity_in_world[2] += ask.h * force_up / mass;
    ask.frame.position_in_world[2] += ask.h * ask.frame.velocity_in_world[2];
  }
  return answer;
}

TEST(ForceOnFrameSign, PullsADroppedWheelIntoTheGroundUntilItBreaks) {
  EXPECT_EQ(drop({Erratum::force_on_frame_sign}), StepAnswer(StepFailure::wheel_broken));
  const StepAnswer rest = drop(none);
  EXPECT_EQ(contact(rest).grip, Grip::stick);
  EXPECT_NEAR(stepped(rest).force_on_frame_in_world[2], 981, 1);
}

TEST(NoLiftoff, WheelFliesOffAndItsPebbleSticks) {
  StepAsk ask = pressed();
  ask.frame.position_in_world[2] = 100;
  const StepAnswer as_written = step(ground(), ask, {Erratum::no_liftoff});
  EXPECT_EQ(as_written, StepAnswer(Stepped{ask.state, {0, 0, 0}}));
  EXPECT_EQ(step(ground(), ask, none), StepAnswer(Stepped{Free{}, {0, 0, 0}}));
}

TEST(TensileContact, GroundPullsTheWheelDownOnRebound) {
  StepAsk ask = pressed();
  ask.frame.velocity_in_world = {0, 0, 8};  // 2500 N of springs less 4000 N of dampers
  EXPECT_NEAR(stepped(step(ground(), ask, {Erratum::tensile_contact})).force_on_frame_in_world[2], -1500,
              1e-9);
  EXPECT_EQ(step(ground(), ask, none), StepAnswer(Stepped{Free{}, {0, 0, 0}}));
}

TEST(SpringRelocation, JumpsWhereStickMeetsSlip) {
  // A pebble 1 m ahead: the springs' 1000 N and the dampers' 250.0001 N are just over mu N = 1250 N.
  StepAsk ask = pressed();
  ask.wheel.relocation = Relocation::return_mapping;
  std::get<Contact>(ask.state).pebble_in_world = {1, 0, 0};
  ask.frame.velocity_in_world = {-2.500001, 0, 0};
  EXPECT_NEAR(contact(step(ground(), ask, {Erratum::spring_relocation})).pebble_in_world[0], 1.25, 1e-9);
  const StepAnswer mapped = step(ground(), ask, none);
  EXPECT_EQ(contact(mapped).grip, Grip::slip);
  EXPECT_NEAR(contact(mapped).pebble_in_world[0], 1, 1e-6);
}

TEST(SpringRelocation, IsWhatTheWheelAskedForByDefault) {
  StepAsk ask = pressed();
  std::get<Contact>(ask.state).pebble_in_world = {2, 0, 0};
  EXPECT_EQ(step(ground(), ask, {Erratum::spring_relocation}), step(ground(), ask, none));
}

TEST(FrameRotationIgnored, LosesTheDampingOfATurningFrame) {
  // The frame turns by 2 rad/s under a pebble 0.5 m ahead: the pebble passes at 1 m/s towards -y.
  StepAsk ask = pressed();
  std::get<Contact>(ask.state).pebble_in_world = {0.5, 0, 0};
  ask.frame.angular_velocity_in_world = {0, 0, 2};
  const Vector without =
      stepped(step(ground(), ask, {Erratum::frame_rotation_ignored})).force_on_frame_in_world;
  const Vector with = stepped(step(ground(), ask, none)).force_on_frame_in_world;
  EXPECT_NEAR(without[1], 0, 1e-9);
  EXPECT_NEAR(with[1], -100, 1e-9);
  EXPECT_NEAR(with[0], 500, 1e-9);
}

TEST(Step, StuckPebbleStaysToTheLastBit) {
  StepAsk ask = pressed();
  std::get<Contact>(ask.state).pebble_in_world = {1.0 / 3, 1e-17, 1e-3};
  EXPECT_EQ(step(ground(), ask, none),
            StepAnswer(Stepped{ask.state, stepped(step(ground(), ask, none)).force_on_frame_in_world}));
}

TEST(Step, SlippingPebbleGoesWhereTheSpringBearsTheClippedForce) {
  StepAsk ask = pressed();
  std::get<Contact>(ask.state).pebble_in_world = {3, 0, 0};
  const StepAnswer answer = step(ground(), ask, none);
  EXPECT_EQ(contact(answer), (Contact{Grip::slip, {1.25, 0, 0}, {-175, 0, 0}, {0, 0, 1}, 0.5, 0.25, 1e7}));
  EXPECT_EQ(stepped(answer).force_on_frame_in_world, (Vector{1250, 0, 2500}));
}

TEST(Step, DecisionsComeInTheContractsOrder) {
  StepAsk ask = pressed();
  Contact& state = std::get<Contact>(ask.state);
  state.maximum_force = 2499;
  EXPECT_EQ(step(ground(), ask, none), StepAnswer(StepFailure::surface_gave_way));
  state.normal_in_world = {0, 0, -1};
  EXPECT_EQ(step(ground(), ask, none), StepAnswer(StepFailure::surface_too_steep));
  state.pebble_in_world = {0, 0, 0.25};
  EXPECT_EQ(step(ground(), ask, none), StepAnswer(StepFailure::wheel_broken));
}

TEST(Step, FreeWheelMeetsTheGroundOrDoesNot) {
  StepAsk ask = pressed();
  ask.state = Free{};
  const Contact met{Grip::stick, {0, 0, 0}, {0, 0, 0}, {0, 0, 1}, 0.5, 0.25, 1e7};
  EXPECT_EQ(step(ground(), ask, none), StepAnswer(Stepped{met, {0, 0, 0}}));
  ask.frame.position_in_world[2] = 0.75;  // just touching
  EXPECT_EQ(step(ground(), ask, none), StepAnswer(Stepped{Free{}, {0, 0, 0}}));
  ask.frame.position_in_world[2] = 0.25;
  EXPECT_EQ(step(ground(), ask, none), StepAnswer(StepFailure::wheel_broken));
}

TEST(Step, ContactWithoutFrictionIsRefusedByLeafAndMaterial) {
  StepAsk ask = pressed();
  ask.state = Free{};
  EXPECT_EQ(step(bare(half_space({0, 0, 1}, 0)), ask, none),
            StepAnswer(Refusal{"contact: leaf 0 has no material"}));
  ask.wheel.tyre = "wood";
  EXPECT_EQ(step(ground(), ask, none),
            StepAnswer(Refusal{"contact: leaf 0: material 'dry' has no friction for 'wood'"}));
}

TEST(Step, NumberThatNoDoubleHoldsIsRefusedByName) {
  StepAsk ask = pressed();
  ask.wheel.k_z = -std::numeric_limits<double>::max();
  ask.frame.position_in_world[2] = 0.5;
  ask.wheel.d_z = 0;
  ask.wheel.z_zero = ask.wheel.z_max = 8;
  EXPECT_EQ(step(ground(), ask, none),
            StepAnswer(Refusal{"the force on the pebble leaves the range of doubles"}));
}

}  // namespace
}  // namespace groundtruth::as_written
