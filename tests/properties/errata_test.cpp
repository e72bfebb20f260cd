// SPEC section 7 row by row: each counterexample to the source document, answered right. (That it goes wrong
// as written is shown in tests/reference/as_written.)

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <groundtruth/tests/properties/generators.hpp>
#include <groundtruth/tests/properties/step_cases.hpp>

namespace groundtruth::properties {
namespace {

ClipAnswer clipped(Grip grip, const Vector& force) { return Clipped{grip, force}; }

TEST(Errata, SinglePassIntersection) {
  const Shape left = half_space(1, 0, 0, 0), right = half_space(-1, 0, 0, -1);
  EXPECT_TRUE(Ground(all_of({left, right})).entry({{-1, 0, 0}, {2, 0, 0}}).is_miss());
  EXPECT_TRUE(Ground(all_of({right, left})).entry({{-1, 0, 0}, {2, 0, 0}}).is_miss());
}

TEST(Errata, NormalByOrder) {
  const Shape near = half_space(1, 0, 0, 0), far = half_space(1, 0, 0, 1), opposite = half_space(-1, 0, 0, 0);
  for (const Shape& shape :
       {any_of({near, far}), any_of({far, near}), any_of({near, opposite}), any_of({opposite, near})})
    EXPECT_TRUE(Ground(shape).entry({{0, 0, 0}, {-1, 0, 0}}).is_inside());
  EXPECT_EQ(Ground(any_of({near, far})).entry({{2, 0, 0}, {-1, 0, 0}}).admissible, std::vector<Leaf>{1});
  EXPECT_EQ(Ground(any_of({far, near})).entry({{2, 0, 0}, {-1, 0, 0}}).admissible, std::vector<Leaf>{0});
}

TEST(Errata, MissIsPlus1000) {
  const Ground above(half_space(0, 0, -1, -1));
  for (const double last : {0x1p63, 0x1p64, 0x1p200, 0x1.fffffffffffffp1023}) {
    EXPECT_TRUE(above.entry({{0, 0, 0}, {1, 0, 0}, 0, last}).is_miss());
    EXPECT_TRUE(above.entry({{0, 0, 0}, {1, 0, 0}, last, last}).is_miss());
  }
}

// The source's six planes, then the floor that a bounded house needs.
TEST(Errata, HouseCorners) {
  std::vector<Shape> planes{half_space(0, -1, 0, 4), half_space(0, 1, 0, 4), half_space(1, 0, 0, 3),
                            half_space(-1, 0, 0, 3), half_space(1, 0, 1, 7), half_space(-1, 0, 1, 7)};
  const EntryAsk cellar{{0, 0, -1000}, {0, 0, -1000}}, missing_corner{{3, -4, 0}, {3, -4, 0}};
  EXPECT_TRUE(Ground(all_of(planes)).entry(cellar).is_inside());
  planes.push_back(half_space(0, 0, -1, 0));
  const Ground house(all_of(planes));
  EXPECT_TRUE(house.entry(cellar).is_miss());
  EXPECT_EQ(house.entry(missing_corner).admissible, (std::vector<Leaf>{0, 2, 6}));
  EXPECT_EQ(house.entry({{-3, 4, 0}, {-3, 4, 0}}).admissible, (std::vector<Leaf>{1, 3, 6}));
  EXPECT_EQ(house.entry({{0, 4, 7}, {0, 4, 7}}).admissible, (std::vector<Leaf>{1, 4, 5}));
}

// Q (0, 0, 1) is -n / ||n||: a force along n has no tangential part for a border of width 0 to take away.
RC_GTEST_PROP(Errata, SurfaceFrameSign, ()) {
  ClipAsk ask = *lattice_clips();
  const double k = *rc::gen::inRange(-9, 10);
  ask.force_in_wheel = ask.normal_in_wheel;
  for (double& f : ask.force_in_wheel) f *= k;
  ask.friction = ask.brake = 0;
  const ClipAnswer answer = clip(ask);
  RC_ASSERT(std::holds_alternative<TooSteep>(answer) || answer == clipped(Grip::stick, ask.force_in_wheel));
}

// X = (4, 0, 3) / 5, Z = (-3, 0, 4) / 5: F = 10 X + 20 Z, then F = 20 Z.
TEST(Errata, BandTestWheelX) {
  EXPECT_EQ(clip({{-4, 0, 22}, {3, 0, -4}, 1, 5}), clipped(Grip::slip, {-8, 0, 19}));
  EXPECT_EQ(clip({{-12, 0, 16}, {3, 0, -4}, 1, 5}), clipped(Grip::stick, {-12, 0, 16}));
}

TEST(Errata, SignedNormalForce) {
  EXPECT_EQ(clip({{3, 4, 10}, {0, 0, -1}, 0.25, 100}), clipped(Grip::slip, {1.5, 2, 10}));
  EXPECT_EQ(clip({{3, 4, -10}, {0, 0, -1}, 0.25, 100}), clipped(Grip::slip, {1.5, 2, -10}));
}

// z points down: what is pressed into the ground is pushed up.
TEST(Errata, ForceOnFrameSign) {
  const StepAnswer answer = Ground(ground_at(1)).step(plain_step(contact(Grip::stick, {0.25, 0, 1})));
  EXPECT_EQ(force_of(answer), (Vector{1, 0, -4}));
}

TEST(Errata, NoLiftoff) {
  for (const Grip grip : {Grip::stick, Grip::slip})
    EXPECT_EQ(Ground(ground_at(1)).step(plain_step(contact(grip, {0, 0, 2.5}))),
              StepAnswer(Stepped({Free{}, {}})));
}

TEST(Errata, TensileContact) {
  for (const Grip grip : {Grip::stick, Grip::slip}) {
    StepAsk ask = plain_step(contact(grip, {0, 0, 1}));
    ask.wheel.d_z = -2;
    ask.frame.velocity_in_world = {0, 0, -3};
    EXPECT_EQ(Ground(ground_at(1)).step(ask), StepAnswer(Stepped({Free{}, {}})));
  }
}

// The spring's rule stays the default; see step_relocation_test.cpp for what it does and for its cure.
TEST(Errata, SpringRelocation) {
  EXPECT_EQ(Wheel{}.relocation, Relocation::spring);
  StepAsk ask = plain_step(contact(Grip::slip, {3, 4, 1}));
  ask.wheel.d_xy = -2;
  std::get<Contact>(ask.state).dynamic_friction = 2.5;
  EXPECT_EQ(contact_of(Ground(ground_at(1)).step(ask)).pebble_in_world, (Vector{1.5, 2, 1}));
  ask.wheel.relocation = Relocation::return_mapping;
  EXPECT_EQ(contact_of(Ground(ground_at(1)).step(ask)).pebble_in_world, (Vector{2.25, 3, 1}));
}

// Pitching about y at 1 rad/s moves the frame over a pebble 1 m down at omega x (p - b) = (1, 0, 0) m/s.
TEST(Errata, FrameRotationIgnored) {
  StepAsk ask = plain_step(contact(Grip::stick, {0, 0, 1}));
  ask.wheel.d_xy = -2;
  EXPECT_EQ(force_of(Ground(ground_at(1)).step(ask)), (Vector{0, 0, -4}));
  ask.frame.angular_velocity_in_world = {0, 1, 0};
  EXPECT_EQ(force_of(Ground(ground_at(1)).step(ask)), (Vector{-2, 0, -4}));
}

// The wheel's x points along the world's y; pebble, velocities and normal are the world's.
TEST(Errata, MixedFrames) {
  Contact far = contact(Grip::stick, {10, 20.5, 31});
  far.pebble_velocity_in_world = {7, 8, 9};
  StepAsk ask = plain_step(far);
  ask.wheel.d_xy = -1;
  ask.frame = {{10, 20, 30}, {1, 0, 0, 1}, {7, 8.25, 9}, {}};
  // p = (0.5, 0, 1), w = (-0.25, 0, 0): F = (-1.75, 0, 4).
  EXPECT_EQ(force_of(Ground(ground_at(31)).step(ask)), (Vector{0, 1.75, -4}));
  // A normal that leans against world x leans against wheel -y.
  std::get<Contact>(ask.state).normal_in_world = {3, 0, -4};
  std::get<Contact>(ask.state).static_friction = 0;
  std::get<Contact>(ask.state).pebble_in_world = {10, 20, 31};
  ask.wheel.d_xy = 0;
  ask.brake = 0;
  // F = (0, 0, 4): of it, n (F.n) / n^2 = -16/25 (3, 0, -4) is left.
  EXPECT_EQ(force_of(Ground(ground_at(31)).step(ask)), (Vector{1.92, 0, -2.56}));
}

}  // namespace
}  // namespace groundtruth::properties
