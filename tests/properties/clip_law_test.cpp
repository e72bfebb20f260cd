// Laws of SPEC section 4 that doubles can state, on both engines.

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <groundtruth/tests/properties/generators.hpp>
#include <groundtruth/tests/properties/witnesses.hpp>

namespace groundtruth::properties {
namespace {

ClipAnswer with_force_times(const ClipAnswer& answer, const Vector& factors) {
  if (!std::holds_alternative<Clipped>(answer)) return answer;
  Clipped clipped = std::get<Clipped>(answer);
  for (std::size_t i = 0; i < 3; ++i) clipped.force_in_wheel[i] *= factors[i];
  return clipped;
}

Vector times(const Vector& vector, const Vector& factors) {
  return {vector[0] * factors[0], vector[1] * factors[1], vector[2] * factors[2]};
}

RC_GTEST_PROP(ClipLaw, MirrorsFrontAndSideMirrorTheForce, ()) {
  const ClipAsk ask = *rc::gen::oneOf(lattice_clips(), border_clips(), wild_clips());
  for (const Vector& mirror : {Vector{-1, 1, 1}, Vector{1, -1, 1}}) {
    ClipAsk mirrored = ask;
    mirrored.force_in_wheel = times(ask.force_in_wheel, mirror);
    mirrored.normal_in_wheel = times(ask.normal_in_wheel, mirror);
    RC_ASSERT(clip(mirrored) == with_force_times(clip(ask), mirror));
  }
}

// The border depends on N = |F'_z|: a pull is clipped like the push as strong.
RC_GTEST_PROP(ClipLaw, TheOppositeForceIsClippedToTheOpposite, ()) {
  const ClipAsk ask = *rc::gen::oneOf(lattice_clips(), border_clips(), wild_clips());
  ClipAsk opposite = ask;
  opposite.force_in_wheel = times(ask.force_in_wheel, {-1, -1, -1});
  RC_ASSERT(clip(opposite) == with_force_times(clip(ask), {-1, -1, -1}));
}

// But for subnormal results, which round to fewer digits than their multiples.
RC_GTEST_PROP(ClipLaw, ForcesAndBrakeScaleTogetherAndTheNormalsLengthDoesNotMatter, ()) {
  const ClipAsk ask = *lattice_clips();
  const double scale = *rc::gen::element(2.0, 0.5, 0x1p100, 0x1p-100);
  ClipAsk scaled = ask;
  scaled.force_in_wheel = times(ask.force_in_wheel, {scale, scale, scale});
  scaled.brake = ask.brake * scale;
  RC_ASSERT(clip(scaled) == with_force_times(clip(ask), {scale, scale, scale}));
  ClipAsk longer = ask;
  longer.normal_in_wheel = times(ask.normal_in_wheel, {3 * scale, 3 * scale, 3 * scale});
  RC_ASSERT(clip(longer) == clip(ask));
}

RC_GTEST_PROP(ClipLaw, StickKeepsTheForceBitForBit, ()) {
  const ClipAsk ask = *rc::gen::oneOf(lattice_clips(), border_clips(), wild_clips());
  const ClipAnswer answer = clip(ask);
  const auto* clipped = std::get_if<Clipped>(&answer);
  if (clipped && clipped->grip == Grip::stick) RC_ASSERT(clipped->force_in_wheel == ask.force_in_wheel);
}

// n_z^2 against t^2 (n_x^2 + n_y^2) and the sign of n_z, whatever the force, friction and brake.
RC_GTEST_PROP(ClipLaw, TooSteepSpeaksOfTheNormalOnly, ()) {
  const ClipAsk ask = *rc::gen::oneOf(lattice_clips(), wild_clips());
  const Rational x(ask.normal_in_wheel[0]), y(ask.normal_in_wheel[1]), z(ask.normal_in_wheel[2]);
  const Rational t(ask.min_uprightness);
  const bool upright = z < 0 && z * z >= t * t * (x * x + y * y);
  RC_ASSERT(std::holds_alternative<TooSteep>(clip(ask)) == !upright);
  ClipAsk other = ask;
  other.force_in_wheel = {};
  other.friction = other.brake = 0;
  RC_ASSERT(std::holds_alternative<TooSteep>(clip(other)) == !upright);
}

// Case 2: Y s and Z F'_z, each with a root of its own, cancel in y.
TEST(ClipLaw, RootsThatCancelLeaveZero) {
  EXPECT_EQ(clip({{0, 1, -2}, {0, -2, -2}, 1, 0}), ClipAnswer(Clipped({Grip::slip, {0, 0, -1}})));
  EXPECT_EQ(clip({{1, 1, -1}, {0, -1, -4}, 0.25, 0}), ClipAnswer(Clipped({Grip::slip, {0, 0, -0.75}})));
}

TEST(ClipLaw, TheLimitOfUprightnessIsUprightAndOneUlpBeyondIsNot) {
  ClipAsk ask{{1, 1, 1}, {3, 4, -5}, 1, 1, 1};
  EXPECT_TRUE(std::holds_alternative<Clipped>(clip(ask)));
  ask.normal_in_wheel[2] = std::nextafter(-5.0, 0.0);
  EXPECT_TRUE(std::holds_alternative<TooSteep>(clip(ask)));
  ask.normal_in_wheel = {3, std::nextafter(4.0, 5.0), -5};
  EXPECT_TRUE(std::holds_alternative<TooSteep>(clip(ask)));
  for (const Vector& normal : {Vector{0, 0, 0}, Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}}) {
    ask.normal_in_wheel = normal;
    EXPECT_TRUE(std::holds_alternative<TooSteep>(clip(ask)));
  }
}

}  // namespace
}  // namespace groundtruth::properties
