#include <cmath>

#include <gtest/gtest.h>

#include <groundtruth/definition/clip.hpp>

namespace groundtruth::definition {
namespace {

const Vector level{0, 0, -1};

Clipped clipped(const Vector& force, double friction, double brake, const Vector& normal = level) {
  return std::get<Clipped>(clip({force, normal, friction, brake}));
}

Clipped stick(const Vector& force) { return {Grip::stick, force}; }
Clipped slip(const Vector& force) { return {Grip::slip, force}; }

bool is_too_steep(const Vector& normal, double min_uprightness) {
  return std::holds_alternative<TooSteep>(clip({{1, 2, 3}, normal, 1, 1, min_uprightness}));
}

TEST(Clip, OfAForceOnTheBorderSticks) {
  EXPECT_EQ(clipped({3, 4, 10}, 0.5, 3), stick({3, 4, 10}));
  EXPECT_EQ(clipped({5, 0, 10}, 0.5, 5), stick({5, 0, 10}));
  EXPECT_EQ(clipped({0, -5, 10}, 0.5, 0), stick({0, -5, 10}));
}

TEST(Clip, OfAForceAnUlpOutsideSlips) {
  EXPECT_EQ(clipped({3, 4, 10}, 0.5, std::nextafter(3.0, 0)).grip, Grip::slip);
  EXPECT_EQ(clipped({3, std::nextafter(4.0, 5), 10}, 0.5, 3).grip, Grip::slip);
}

TEST(Clip, OntoTheBandKeepsTheSidewaysForce) {
  EXPECT_EQ(clipped({-7, 2, 10}, 0.5, 3), slip({-3, 2, 10}));
  EXPECT_EQ(clipped({7, -4, 10}, 0.5, 3), slip({3, -4, 10}));
}

TEST(Clip, OntoACornerOfDiscAndBand) {
  EXPECT_EQ(clipped({-30, 5, 10}, 0.5, 3), slip({-3, 4, 10}));
  EXPECT_EQ(clipped({6, -8, 10}, 0.5, 3), slip({3, -4, 10}));
}

TEST(Clip, OntoTheDisc) {
  EXPECT_EQ(clipped({6, 8, 10}, 0.5, 100), slip({3, 4, 10}));
  EXPECT_EQ(clipped({0, -8, 10}, 0.5, 3), slip({0, -5, 10}));
  EXPECT_EQ(clipped({6, 8, 10}, 0.5, 5), slip({3, 4, 10}));
}

TEST(Clip, WithoutFrictionLeavesTheNormalForce) {
  EXPECT_EQ(clipped({6, 8, 10}, 0, 5), slip({0, 0, 10}));
  EXPECT_EQ(clipped({0, 0, 10}, 0, 0), stick({0, 0, 10}));
  EXPECT_EQ(clipped({1, 0, 0}, 0.5, 5), slip({0, 0, 0}));
}

TEST(Clip, ClipsAPullLikeAPush) {
  EXPECT_EQ(clipped({6, 8, -10}, 0.5, 100), slip({3, 4, -10}));
  EXPECT_EQ(clipped({-7, 2, -10}, 0.5, 3), slip({-3, 2, -10}));
}

TEST(Clip, TestsTheBandAlongTheSurface) {
  // The surface rises ahead with slope 3/4: X = (4, 0, -3)/5, Z = (3, 0, 4)/5.
  const Vector slope{-3, 0, -4};
  EXPECT_EQ(clipped({4, 0, -3}, 1, 5, slope), slip({0, 0, 0}));
  // F' = (5, 0, 10): N = 10.
  EXPECT_EQ(clipped({10, 0, 5}, 1, 5, slope), stick({10, 0, 5}));
  EXPECT_EQ(clipped({10, 0, 5}, 1, 0, slope), slip({6, 0, 8}));
}

TEST(Clip, OnASidewaysSlopeKeepsTheRollingDirection) {
  // n = (0, -3, -4): X = (1, 0, 0), Y = (0, 4, -3)/5, Z = (0, 3, 4)/5; F' = (2, 5, 10).
  const Vector slope{0, -3, -4};
  EXPECT_EQ(clipped({2, 10, 5}, 1, 2, slope), stick({2, 10, 5}));
  EXPECT_EQ(clipped({2, 10, 5}, 1, 1, slope), slip({1, 10, 5}));
  EXPECT_EQ(clipped({0, 10, 5}, 0.25, 1, slope), slip({0, 8, 6.5}));
}

TEST(Clip, DoesNotDependOnTheLengthOfTheNormal) {
  const Clipped once = clipped({20, -7, 11}, 0.4, 3, {0.25, 0.5, -1});
  EXPECT_EQ(clipped({20, -7, 11}, 0.4, 3, {0x1p900, 0x1p901, -0x1p902}), once);
  EXPECT_EQ(clipped({20, -7, 11}, 0.4, 3, {0x1p-1030, 0x1p-1029, -0x1p-1028}), once);
}

TEST(Clip, IsTooSteepExactlyBelowMinUprightness) {
  EXPECT_FALSE(is_too_steep({3, 4, -5}, 1));
  EXPECT_TRUE(is_too_steep({3, 4, -5}, std::nextafter(1.0, 2)));
  EXPECT_TRUE(is_too_steep({3, 4, -std::nextafter(5.0, 0)}, 1));
  EXPECT_TRUE(is_too_steep({0, 0, 1}, 0.1));
  EXPECT_TRUE(is_too_steep({0, 0, 0}, 0.1));
  EXPECT_TRUE(is_too_steep({1, 0, 0}, 0x1p-1074));
  EXPECT_FALSE(is_too_steep({0, 0, -0x1p-1074}, 1e300));
}

TEST(Clip, GivesNoNegativeZero) {
  const Clipped result = clipped({-1, -1, 0}, 0.5, 5);
  EXPECT_EQ(result, slip({0, 0, 0}));
  for (const double f : result.force_in_wheel) EXPECT_FALSE(std::signbit(f));
  EXPECT_FALSE(std::signbit(clipped({-0.0, 0, 1}, 1, 1).force_in_wheel[0]));
}

TEST(Clip, RefusesAForceThatNoDoubleHolds) {
  // Without friction all that is left is the pressing part, whose y is 8 * 14/82 = 1.36 times as large.
  const double f = 1.7e308;
  const ClipAnswer answer = clip({{f, f, f}, {-3, -8, -3}, 0, 0});
  ASSERT_TRUE(std::holds_alternative<Refusal>(answer));
  EXPECT_NE(std::get<Refusal>(answer).reason.find("force[1]"), std::string::npos);
}

}  // namespace
}  // namespace groundtruth::definition
