#include <groundtruth/fast/step.hpp>

#include <gtest/gtest.h>
#include <groundtruth/tests/fast/shapes.hpp>

namespace groundtruth {
namespace {

constexpr double mu_static = 0.5, mu_dynamic = 0.25;

Scene scene_of(Shape shape) {
  const Friction rubber{mu_static, mu_dynamic};
  return {{{"dry", {{"rubber", rubber}}, 1e7}}, std::move(shape)};
}
Scene ground() { return scene_of(cover(0, half_space({0, 0, 1}, 0))); }

// The wheel's frame is turned about x by a half-turn: its z points down, its y to the world's -y. At rest
// half a metre above the ground the spring is compressed by a quarter, and presses with 256 N.
StepAsk resting() {
  StepAsk ask;
  ask.wheel = {.k_xy = -1024,
               .k_z = -1024,
               .d_xy = 0,
               .d_z = 0,
               .z_min = 0.25,
               .z_zero = 0.75,
               .z_max = 0.75,
               .tyre = "rubber"};
  ask.frame.position_in_world = {1, 2, 0.5};
  ask.frame.world_from_wheel = {0, 1, 0, 0};
  ask.brake = 1000;
  ask.h = 0.5;
  return ask;
}

Contact contact(Grip grip, Vector pebble) {
  return {.grip = grip,
          .pebble_in_world = pebble,
          .pebble_velocity_in_world = {},
          .normal_in_world = {0, 0, 1},
          .static_friction = mu_static,
          .dynamic_friction = mu_dynamic,
          .maximum_force = 1e7};
}

StepAsk in_contact(Grip grip, Vector pebble) {
  StepAsk ask = resting();
  ask.state = contact(grip, pebble);
  return ask;
}

StepAnswer take(const StepAsk& ask, const Scene& scene = ground()) {
  return fast::step(fast::compile(scene), ask);
}

StepAnswer now_free(Vector force = {}) { return Stepped{Free{}, force}; }
StepAnswer now(const Contact& state, Vector force) { return Stepped{state, force}; }

TEST(FastStepFromFree, MissingTheGroundStaysFree) {
  StepAsk ask = resting();
  ask.frame.position_in_world[2] = 2;
  EXPECT_EQ(take(ask), now_free());
}

TEST(FastStepFromFree, ReachingTheGroundAtFullLengthStaysFree) {
  StepAsk ask = resting();
  ask.frame.position_in_world[2] = 0.75;
  EXPECT_EQ(take(ask), now_free());
}

TEST(FastStepFromFree, WithItsTopOnOrUnderTheGroundIsBroken) {
  StepAsk ask = resting();
  for (const double height : {0.25, 0.125}) {
    ask.frame.position_in_world[2] = height;
    EXPECT_EQ(take(ask), StepAnswer(StepFailure::wheel_broken)) << height;
  }
}

TEST(FastStepFromFree, TouchingGroundSticksWithoutForce) {
  EXPECT_EQ(take(resting()), now(contact(Grip::stick, {1, 2, 0}), {}));
}

TEST(FastStepFromFree, OrientationNeedNotBeNormalised) {
  StepAsk ask = resting();
  ask.frame.world_from_wheel = {0, -3, 0, 0};
  EXPECT_EQ(take(ask), now(contact(Grip::stick, {1, 2, 0}), {}));
}

TEST(FastStepFromFree, SteepGroundIsTooSteepWhateverItIsMadeOf) {
  StepAsk ask = resting();
  ask.wheel.min_uprightness = 1;
  EXPECT_EQ(take(ask, scene_of(half_space({1, 1, 1}, 3))), StepAnswer(StepFailure::surface_too_steep));
}

TEST(FastStepFromFree, ContactWithoutMaterialOrFrictionIsRefused) {
  const Scene bare = scene_of(unite({half_space({0, 0, 1}, -1), half_space({0, 0, 1}, 0)}));
  EXPECT_EQ(take(resting(), bare), StepAnswer(Refusal{"contact: leaf 1 has no material"}));
  StepAsk metal = resting();
  metal.wheel.tyre = "metal";
  EXPECT_EQ(take(metal), StepAnswer(Refusal{"contact: leaf 0: material 'dry' has no friction for 'metal'"}));
}

TEST(FastStepFromFree, WithoutFrictionIsNoMatterWhereThereIsNoContact) {
  StepAsk metal = resting();
  metal.wheel.tyre = "metal";
  metal.frame.position_in_world[2] = 0.75;
  EXPECT_EQ(take(metal), now_free());
  metal.frame.position_in_world[2] = 0.25;
  EXPECT_EQ(take(metal), StepAnswer(StepFailure::wheel_broken));
}

TEST(FastStepContact, FullyExtendedComesFree) {
  StepAsk ask = in_contact(Grip::stick, {1, 2, -0.25});
  EXPECT_EQ(take(ask), now_free());
  std::get<Contact>(ask.state).normal_in_world = {1, 0, 0};
  EXPECT_EQ(take(ask), now_free()) << "decided before steepness";
}

TEST(FastStepContact, FullyCompressedIsBroken) {
  StepAsk ask = in_contact(Grip::slip, {1, 2, 0.25});
  std::get<Contact>(ask.state).normal_in_world = {1, 0, 0};
  EXPECT_EQ(take(ask), StepAnswer(StepFailure::wheel_broken));
}

TEST(FastStepContact, OnATurnedSurfaceIsTooSteep) {
  StepAsk ask = in_contact(Grip::stick, {1, 2, 0});
  std::get<Contact>(ask.state).normal_in_world = {1, 0, 0};
  EXPECT_EQ(take(ask), StepAnswer(StepFailure::surface_too_steep));
}

TEST(FastStepContact, ThatNothingPressesComesFreeWithoutForce) {
  StepAsk ask = in_contact(Grip::stick, {1, 2, 0});
  ask.frame.velocity_in_world = {0, 0, 1};
  ask.wheel.d_z = -256;
  EXPECT_EQ(take(ask), now_free()) << "F'_z = 0";
  ask.wheel.d_z = -255;
  EXPECT_EQ(take(ask), now(contact(Grip::stick, {1, 2, 0}), {0, 0, 1}));
}

TEST(FastStepContact, OverItsMaximumForceGivesWay) {
  StepAsk ask = in_contact(Grip::stick, {1, 2, 0});
  Contact& state = std::get<Contact>(ask.state);
  state.maximum_force = 256;
  EXPECT_EQ(take(ask), now(state, {0, 0, 256}));
  state.maximum_force = 255;
  EXPECT_EQ(take(ask), StepAnswer(StepFailure::surface_gave_way));
  state.maximum_force.reset();
  EXPECT_EQ(take(ask), now(state, {0, 0, 256}));
}

TEST(FastStepContact, WithinTheBorderSticksWhereItIs) {
  StepAsk ask = in_contact(Grip::slip, {1.0625, 2, 0});
  std::get<Contact>(ask.state).pebble_velocity_in_world = {0, 0, 0.5};
  EXPECT_EQ(take(ask), now(contact(Grip::stick, {1.0625, 2, 0}), {64, 0, 256}));
}

TEST(FastStepContact, OfAFrameThatTurnsIsDamped) {
  StepAsk ask = in_contact(Grip::stick, {1, 2, 0});
  ask.wheel.d_xy = -64;
  ask.frame.angular_velocity_in_world = {0, 2, 0};
  EXPECT_EQ(take(ask), now(contact(Grip::stick, {1, 2, 0}), {64, 0, 256}));
}

TEST(FastStepSlip, OverTheBrakeFollowsTheWheel) {
  StepAsk ask = in_contact(Grip::stick, {1.0625, 2, 0});
  ask.brake = 32;
  Contact expected = contact(Grip::slip, {1.03125, 2, 0});
  expected.pebble_velocity_in_world = {-0.0625, 0, 0};
  EXPECT_EQ(take(ask), now(expected, {32, 0, 256}));
}

TEST(FastStepSlip, StartsAtStaticAndGoesOnAtDynamicFriction) {
  Contact expected = contact(Grip::slip, {1, 2.125, 0});
  expected.pebble_velocity_in_world = {0, -0.25, 0};
  EXPECT_EQ(take(in_contact(Grip::stick, {1, 2.25, 0})), now(expected, {0, 128, 256}));
  expected.pebble_in_world[1] = 2.0625;
  expected.pebble_velocity_in_world[1] = -0.375;
  EXPECT_EQ(take(in_contact(Grip::slip, {1, 2.25, 0})), now(expected, {0, 64, 256}));
}

TEST(FastStepSlip, ByReturnMappingMovesLess) {
  StepAsk ask = in_contact(Grip::stick, {1, 2.25, 0});
  ask.wheel.d_xy = -512;
  ask.wheel.relocation = Relocation::return_mapping;
  Contact expected = contact(Grip::slip, {1, 2.1875, 0});
  expected.pebble_velocity_in_world = {0, -0.125, 0};
  EXPECT_EQ(take(ask), now(expected, {0, 128, 256}));
}

TEST(FastStepSlip, OverAnEdgeComesFreeWithTheForceOfTheStep) {
  const Shape narrow = cover(0, intersect({half_space({0, 0, 1}, 0), half_space({0, 1, 0}, 2)}));
  EXPECT_EQ(take(in_contact(Grip::stick, {1, 2.25, 0}), scene_of(narrow)), now_free({0, 128, 256}));
}

TEST(FastStepSlip, OffGroundAtFullLengthComesFreeWithTheForceOfTheStep) {
  const Shape lower = cover(0, half_space({0, 0, 1}, -0.25));
  EXPECT_EQ(take(in_contact(Grip::stick, {1, 2.25, 0}), scene_of(lower)), now_free({0, 128, 256}));
}

TEST(FastStepSlip, IntoAKerbAsHighAsTheWheelIsBroken) {
  const Shape kerb = cover(0, half_space({0, 0, 1}, 0.25));
  EXPECT_EQ(take(in_contact(Grip::stick, {1, 2.25, 0}), scene_of(kerb)),
            StepAnswer(StepFailure::wheel_broken));
}

TEST(FastStepSlip, OntoASlopeMayBeTooSteep) {
  StepAsk ask = in_contact(Grip::stick, {1, 2.25, 0});
  ask.wheel.min_uprightness = 1;
  EXPECT_EQ(take(ask, scene_of(half_space({3, 0, 1}, 3))), StepAnswer(StepFailure::surface_too_steep));
}

TEST(FastStepSlip, TakesNormalAndFrictionOfTheNewSurface) {
  const Shape half = cover(1, intersect({half_space({0, 0, 3}, 0), half_space({0, 1, 0}, 2.125)}));
  Scene scene = scene_of(unite({cover(0, half_space({0, 0, 1}, -4)), half}));
  scene.materials.push_back({"wet", {{"rubber", {0.125, 0}}}, std::nullopt});
  Contact expected{Grip::slip, {1, 2.125, 0}, {0, -0.25, 0}, {0, 0, 3}, 0.125, 0, std::nullopt};
  EXPECT_EQ(take(in_contact(Grip::stick, {1, 2.25, 0}), scene), now(expected, {0, 128, 256}));
}

TEST(FastStepSlip, OntoGroundWithoutFrictionIsRefused) {
  EXPECT_EQ(take(in_contact(Grip::stick, {1, 2.25, 0}), scene_of(half_space({0, 0, 1}, 0))),
            StepAnswer(Refusal{"contact: leaf 0 has no material"}));
}

TEST(FastStepRefusal, NamesTheQuantityThatLeavesTheRangeOfDoubles) {
  StepAsk ask = in_contact(Grip::stick, {1, 2.25, 0});
  ask.h = 0x1p-1074;
  EXPECT_EQ(take(ask), StepAnswer(Refusal{"state.velocity[1] leaves the range of doubles"}));
  StepAsk stiff = in_contact(Grip::stick, {1, 2, 0});
  stiff.wheel.k_z = -0x1p1023;
  stiff.wheel.z_max = stiff.wheel.z_zero = 16;
  std::get<Contact>(stiff.state).maximum_force.reset();
  EXPECT_EQ(take(stiff), StepAnswer(Refusal{"force[2] leaves the range of doubles"}));
}

}  // namespace
}  // namespace groundtruth
