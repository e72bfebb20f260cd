#include <groundtruth/as_written/clip.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace groundtruth::as_written {
namespace {

const Errata none{};
const Vector level{0, 0, -1};
const Vector slope_along_x{3, 0, -4};
const Vector slope_along_y{0, 3, -4};

Grip grip_of(const ClipAnswer& answer) { return std::get<Clipped>(answer).grip; }

void expect_slip(const ClipAnswer& answer, const Vector& force) {
  ASSERT_TRUE(std::holds_alternative<Clipped>(answer));
  const Clipped& clipped = std::get<Clipped>(answer);
  EXPECT_EQ(clipped.grip, Grip::slip);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(clipped.force_in_wheel[axis], force[axis], 1e-12 * std::hypot(force[0], force[1], force[2]));
  }
}

TEST(SurfaceFrameSign, LetsAForceAlongTheNormalSlip) {
  for (const Vector& normal : {slope_along_x, slope_along_y}) {
    const Vector into_ground{-100 * normal[0], -100 * normal[1], -100 * normal[2]};
    const ClipAsk ask{into_ground, normal, 0.01, 1};
    EXPECT_EQ(grip_of(clip(ask, {Erratum::surface_frame_sign})), Grip::slip);
    EXPECT_EQ(clip(ask, none), ClipAnswer(Clipped{Grip::stick, into_ground}));
  }
}

TEST(BandTestWheelX, LooksAlongTheWheelInsteadOfTheSurface) {
  // (75, 0, 100) in the surface frame: outside a band of 50, though nothing of it is along the wheel's x.
  const ClipAsk ask{{0, 0, 125}, slope_along_x, 1, 50};
  EXPECT_EQ(clip(ask, {Erratum::band_test_wheel_x}), ClipAnswer(Clipped{Grip::stick, {0, 0, 125}}));
  expect_slip(clip(ask, none), {-20, 0, 110});
}

TEST(SignedNormalForce, TurnsFrictionRoundUnderAPull) {
  const ClipAsk ask{{300, 400, -500}, level, 0.5, 1000};
  expect_slip(clip(ask, {Erratum::signed_normal_force}), {-150, -200, -500});
  expect_slip(clip(ask, none), {150, 200, -500});
}

TEST(Clip, BandAloneIsClippedAlongX) {
  expect_slip(clip({{-30, 40, 100}, level, 1, 10}, none), {-10, 40, 100});
}

TEST(Clip, BandAndCircleTogetherGiveTheirClosestPoint) {
  // mu N = 50: the band of 30 meets the circle at (+-30, +-40).
  expect_slip(clip({{160, -100, 100}, level, 0.5, 30}, none), {30, -40, 100});
  expect_slip(clip({{60, -800, 100}, level, 0.5, 30}, none),
              {50 * 60 / std::hypot(60, 800), -50 * 800 / std::hypot(60, 800), 100});
}

TEST(Clip, TooSteepWhateverTheForce) {
  EXPECT_EQ(clip({{0, 0, 0}, {1, 0, -0.05}, 1, 1}, none), ClipAnswer(TooSteep{}));
  EXPECT_EQ(clip({{0, 0, 0}, {0, 0, 1}, 1, 1}, none), ClipAnswer(TooSteep{}));
  EXPECT_EQ(clip({{0, 0, 0}, {1, 0, -0.05}, 1, 1, 0.01}, none), ClipAnswer(Clipped{}));
}

TEST(Clip, ScaleOfForceAndNormalDoesNotMatter) {
  for (const int exponent : {-900, 0, 900}) {
    const auto scaled = [exponent](double x) { return std::ldexp(x, exponent); };
    const ClipAsk ask{{scaled(300), scaled(400), scaled(500)}, {0, 0, -scaled(1)}, 0.5, scaled(1000)};
    expect_slip(clip(ask, none), {scaled(150), scaled(200), scaled(500)});
  }
}

TEST(Clip, ForceThatNoDoubleHoldsIsRefused) {
  const double most = 1.7e308;
  const ClipAsk ask{{most, 0, most}, {-0.6, 0, -0.8}, 1e-3, most};
  EXPECT_EQ(clip(ask, none), ClipAnswer(Refusal{"the clipped force leaves the range of doubles"}));
}

}  // namespace
}  // namespace groundtruth::as_written
