#include <groundtruth/fast/clip.hpp>

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace groundtruth {
namespace {

constexpr Vector level{0, 0, -1};

ClipAnswer clipped(Grip grip, Vector force) { return Clipped{grip, force}; }

void expect_near(const ClipAnswer& got, Grip grip, const Vector& expected) {
  const auto* result = std::get_if<Clipped>(&got);
  ASSERT_NE(result, nullptr);
  EXPECT_EQ(result->grip, grip);
  for (std::size_t axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(result->force_in_wheel[axis], expected[axis], 1e-12) << "axis " << axis;
}

TEST(FastClipStick, KeepsTheForceBitForBit) {
  const Vector force{0.1, 0.2, -1.7};
  EXPECT_EQ(fast::clip({force, {0.25, 0.125, -1}, 1, 1}), clipped(Grip::stick, force));
}

TEST(FastClipStick, IncludesTheBorder) {
  EXPECT_EQ(fast::clip({{3, 4, -10}, level, 0.5, 3}), clipped(Grip::stick, {3, 4, -10}));
  EXPECT_EQ(fast::clip({{3, 4, 10}, level, 0.5, 5}), clipped(Grip::stick, {3, 4, 10})) << "F'_z < 0";
  EXPECT_EQ(fast::clip({{0, 0, 0}, level, 0, 0}), clipped(Grip::stick, {0, 0, 0}));
}

TEST(FastClipStick, EndsOneUlpOutsideTheBorder) {
  const auto outside = fast::clip({{3, std::nextafter(4.0, 5.0), -10}, level, 0.5, 5});
  EXPECT_EQ(std::get<Clipped>(outside).grip, Grip::slip);
}

TEST(FastClipSlip, OntoTheEdgeOfTheBandKeepsTheAcrossForce) {
  EXPECT_EQ(fast::clip({{-9, 2, -10}, level, 0.5, 3}), clipped(Grip::slip, {-3, 2, -10}));
  EXPECT_EQ(fast::clip({{9, 4, -10}, level, 0.5, 3}), clipped(Grip::slip, {3, 4, -10})) << "|F'_y| = s";
}

TEST(FastClipSlip, BeyondBandAndDiscGoesToTheCorner) {
  EXPECT_EQ(fast::clip({{9, -5, -10}, level, 0.5, 3}), clipped(Grip::slip, {3, -4, -10}));
  EXPECT_EQ(fast::clip({{6, 8, -10}, level, 0.5, 3}), clipped(Grip::slip, {3, 4, -10}))
      << "B |F'_y| = |F'_x| s, where corner and circle agree";
}

TEST(FastClipSlip, OntoTheCircleShortensTheForce) {
  EXPECT_EQ(fast::clip({{6, 8, -10}, level, 0.5, 5}), clipped(Grip::slip, {3, 4, -10}));
  EXPECT_EQ(fast::clip({{0, 9, -10}, level, 0.5, 3}), clipped(Grip::slip, {0, 5, -10}));
  EXPECT_EQ(fast::clip({{6, 8, 10}, level, 0.5, 5}), clipped(Grip::slip, {3, 4, 10})) << "F'_z < 0";
}

TEST(FastClipSlip, WithoutFrictionLeavesTheNormalPart) {
  EXPECT_EQ(fast::clip({{3, 4, -10}, level, 0, 7}), clipped(Grip::slip, {0, 0, -10}));
  EXPECT_EQ(fast::clip({{3, 4, 0}, level, 7, 7}), clipped(Grip::slip, {0, 0, 0}));
}

TEST(FastClipSlip, WithoutBrakeRollsFreely) {
  EXPECT_EQ(fast::clip({{3, 4, -10}, level, 1, 0}), clipped(Grip::slip, {0, 4, -10}));
}

// n = (3, 0, -4): X = (4, 0, 3)/5, Y = (0, 1, 0), Z = (-3, 0, 4)/5.
TEST(FastClipSlope, ClipsInTheSurfacesOwnAxes) {
  // F' = (10, 2, 20).
  expect_near(fast::clip({{-4, 2, 22}, {3, 0, -4}, 0.5, 5}), Grip::slip, {-8, 2, 19});
  expect_near(fast::clip({{-4, 2, 22}, {3, 0, -4}, 0, 5}), Grip::slip, {-12, 0, 16});
}

// n = (0, 3, -4): X = (1, 0, 0), Y = (0, 4, 3)/5, Z = (0, -3, 4)/5.
TEST(FastClipSlope, AcrossTheWheelTiltsTheAcrossAxis) {
  // F' = (1, 10, 10).
  expect_near(fast::clip({{1, 2, 14}, {0, 3, -4}, 0.5, 0}), Grip::slip, {0, -2, 11});
}

TEST(FastClipSlope, AsSteepAsAllowedIsNotTooSteep) {
  EXPECT_FALSE(std::holds_alternative<TooSteep>(fast::clip({{0, 0, 1}, {3, 4, -5}, 1, 1, 1})));
  EXPECT_EQ(fast::clip({{0, 0, 1}, {3, 4, std::nextafter(-5.0, 0.0)}, 1, 1, 1}), ClipAnswer(TooSteep{}));
}

TEST(FastClipSlope, VerticalOverhangingOrWithoutNormalIsTooSteep) {
  for (const Vector normal : {Vector{1, 0, 0}, Vector{0, 0, 1}, Vector{0, 0, 0}})
    EXPECT_EQ(fast::clip({{0, 0, 0}, normal, 1, 1}), ClipAnswer(TooSteep{}));
}

TEST(FastClipNormalLength, DoesNotMatter) {
  const ClipAnswer expected = clipped(Grip::slip, {3, -4, -10});
  for (const double length : {0x1p-1074, 0x1p-500, 3.0, 0x1p500, 0x1p1023})
    EXPECT_EQ(fast::clip({{9, -5, -10}, {0, 0, -length}, 0.5, 3}), expected) << length;
}

TEST(FastClipSize, OfForceAndBrakeScalesTheAnswer) {
  for (const double size : {0x1p-1000, 0x1p-300, 0x1p300, 0x1p1000})
    EXPECT_EQ(fast::clip({{9 * size, -5 * size, -10 * size}, level, 0.5, 3 * size}),
              clipped(Grip::slip, {3 * size, -4 * size, -10 * size}))
        << size;
}

TEST(FastClipRefusal, NamesTheComponentThatLeavesTheRangeOfDoubles) {
  const double huge = 0x1.fffp1023;  // down the slope: |F| > the largest double, all of it along Z
  const auto answer = fast::clip({{-huge, 0, huge}, {1, 0.5, -1}, 0, 0});
  const auto* refusal = std::get_if<Refusal>(&answer);
  ASSERT_EQ(refusal, nullptr) << "the projection is still a double";
  const auto beyond = fast::clip({{-huge, -huge, huge}, {1, 0.875, -1.125}, 0, 0});
  ASSERT_TRUE(std::holds_alternative<Refusal>(beyond));
  EXPECT_EQ(std::get<Refusal>(beyond).reason, "force[2] leaves the range of doubles");
}

// Level ground, small integers: the border's own arithmetic is exact, so the law is exact too.
RC_GTEST_PROP(FastClip, NeverLeavesTheBorderByMoreThanRounding, ()) {
  const auto component = rc::gen::inRange(-1000, 1000);
  const Vector force{double(*component), double(*component), double(*component)};
  const double friction = *rc::gen::inRange(0, 8) / 4.0, brake = *rc::gen::inRange(0, 1000);
  const Clipped result = std::get<Clipped>(fast::clip({force, level, friction, brake}));
  const Vector& h = result.force_in_wheel;
  const double limit = friction * std::abs(force[2]);
  RC_ASSERT(std::abs(h[0]) <= brake * (1 + 1e-15));
  RC_ASSERT(std::hypot(h[0], h[1]) <= limit * (1 + 1e-15));
  RC_ASSERT(h[2] == force[2]);
  const bool is_within =
      std::abs(force[0]) <= brake && force[0] * force[0] + force[1] * force[1] <= limit * limit;
  RC_ASSERT((result.grip == Grip::stick) == is_within);
}

}  // namespace
}  // namespace groundtruth
