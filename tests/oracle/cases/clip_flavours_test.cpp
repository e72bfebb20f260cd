// Are the forces exactly where their flavour says? All of section 4's decisions compare rationals.

#include <cmath>

#include <gtest/gtest.h>

#include <groundtruth/cases/border_cases.hpp>
#include <groundtruth/cases/clip_flavours.hpp>

#include "exact_checks.hpp"

namespace groundtruth::cases {
namespace {

using testing::Rational;

constexpr int tries = 300;

// Squares of the force in the surface's frame and of the border's sizes.
struct Squares {
  Rational x;         // F'_x^2
  Rational y;         // F'_y^2
  Rational friction;  // mu^2 N^2
  Rational band;      // B^2
  Rational s() const { return friction - band; }
};

Squares squares_of(const ClipAsk& ask) {
  const testing::RationalVector n = testing::exactly(ask.normal_in_wheel);
  const testing::RationalVector f = testing::exactly(ask.force_in_wheel);
  const Rational r_squared = n[0] * n[0] + n[2] * n[2];
  const Rational along = -n[2] * f[0] + n[0] * f[2];
  const Rational sideways = -n[0] * n[1] * f[0] + r_squared * f[1] - n[1] * n[2] * f[2];
  const Rational down = testing::dot(n, f);
  const Rational mu(ask.friction);
  const Rational band(ask.brake);
  const Rational n_squared = testing::dot(n, n);
  return {along * along / r_squared, sideways * sideways / (r_squared * n_squared),
          mu * mu * down * down / n_squared, band * band};
}

template <class Check>
void for_many(ClipAsk (*make)(Random&), Check check) {
  for (std::uint64_t i = 0; i < tries; ++i) {
    Random random(i);
    const ClipAsk ask = make(random);
    SCOPED_TRACE(i);
    check(ask, squares_of(ask));
  }
}

TEST(ClipDiscBorder, ForceIsOnTheDiscsBorderAndInTheBand) {
  for_many(clip_disc_border, [](const ClipAsk&, const Squares& f) {
    EXPECT_EQ(f.x + f.y, f.friction);
    EXPECT_LT(f.x, f.band);
  });
}

TEST(ClipBandEdge, ForceIsOnTheBandsEdgeAndInTheDisc) {
  for_many(clip_band_edge, [](const ClipAsk&, const Squares& f) {
    EXPECT_EQ(f.x, f.band);
    EXPECT_LT(f.x + f.y, f.friction);
  });
}

TEST(ClipBorderCorner, ForceIsOnBoth) {
  for_many(clip_border_corner, [](const ClipAsk&, const Squares& f) {
    EXPECT_EQ(f.x, f.band);
    EXPECT_EQ(f.x + f.y, f.friction);
  });
}

TEST(ClipCaseBorder, OneAndTwoMeetWhereFyIsS) {
  for_many(clip_case_border_1_2, [](const ClipAsk&, const Squares& f) {
    EXPECT_EQ(f.y, f.s());
    EXPECT_GT(f.x, f.band);
    EXPECT_GT(f.s(), 0);
  });
}

TEST(ClipCaseBorder, TwoAndThreeMeetOnTheRayThroughTheCorner) {
  for_many(clip_case_border_2_3, [](const ClipAsk&, const Squares& f) {
    EXPECT_EQ(f.band * f.y, f.x * f.s());
    EXPECT_GT(f.x, f.band);
    EXPECT_GT(f.s(), 0);
  });
}

TEST(ClipWideBand, BandIsAsWideAsTheDisc) {
  int inside = 0, on = 0, outside = 0;
  for_many(clip_wide_band, [&](const ClipAsk&, const Squares& f) {
    EXPECT_EQ(f.band, f.friction);
    inside += f.x + f.y < f.friction;
    on += f.x + f.y == f.friction;
    outside += f.x + f.y > f.friction;
  });
  EXPECT_GT(inside, 0);
  EXPECT_GT(on, 0);
  EXPECT_GT(outside, 0);
}

TEST(ClipSteepnessLimit, SurfaceIsExactlyAsSteepAsAllowed) {
  for_many(clip_steepness_limit, [](const ClipAsk& ask, const Squares&) {
    const testing::RationalVector n = testing::exactly(ask.normal_in_wheel);
    const Rational t(ask.min_uprightness);
    EXPECT_LT(n[2], 0);
    EXPECT_EQ(n[2] * n[2], t * t * (n[0] * n[0] + n[1] * n[1]));
  });
}

TEST(ClipHopelessSurface, IsTooSteepNearlyAlways) {
  int steep = 0;
  for (std::uint64_t i = 0; i < tries; ++i) {
    Random random(i);
    const ClipAsk ask = clip_hopeless_surface(random);
    const testing::RationalVector n = testing::exactly(ask.normal_in_wheel);
    const Rational t(ask.min_uprightness);
    steep += n[2] >= 0 || n[2] * n[2] < t * t * (n[0] * n[0] + n[1] * n[1]);
  }
  EXPECT_GT(steep, tries * 9 / 10);
}

TEST(ClipZeros, SomethingIsZero) {
  int no_force = 0, no_friction = 0, no_brake = 0, only_pressed = 0, not_pressed = 0;
  for_many(clip_zeros, [&](const ClipAsk& ask, const Squares& f) {
    const testing::RationalVector force = testing::exactly(ask.force_in_wheel);
    const Rational pressure = testing::dot(force, testing::exactly(ask.normal_in_wheel));
    const bool is_zero = testing::is_zero(force);
    EXPECT_TRUE(f.x == 0 || f.y == 0 || pressure == 0 || ask.friction == 0 || ask.brake == 0);
    no_force += is_zero;
    no_friction += ask.friction == 0;
    no_brake += ask.brake == 0;
    only_pressed += !is_zero && f.x == 0 && f.y == 0;
    not_pressed += !is_zero && pressure == 0;
  });
  for (int seen : {no_force, no_friction, no_brake, only_pressed, not_pressed}) EXPECT_GT(seen, 10);
}

TEST(ClipRandom, NormalForcesHaveBothSigns) {
  int pressed = 0;
  for (std::uint64_t i = 0; i < tries; ++i) {
    Random random(i);
    const ClipAsk ask = clip_random(random);
    pressed += testing::dot(testing::exactly(ask.force_in_wheel), testing::exactly(ask.normal_in_wheel)) < 0;
  }
  EXPECT_GT(pressed, tries / 4);
  EXPECT_LT(pressed, tries * 3 / 4);
}

TEST(BorderCase, PressingMeansThatTheSurfacePushesBack) {
  Random random(1);
  for (int i = 0; i < tries; ++i) {
    const BorderCase border = border_case(BorderPlace::disc, Pressing::yes, 0.5, random);
    EXPECT_LT(testing::dot(testing::exactly(border.force_in_wheel), testing::exactly(border.surface.normal)),
              0);
  }
}

TEST(RationalNormal, LengthsAreExact) {
  Random random(2);
  for (int i = 0; i < tries; ++i) {
    const RationalNormal& surface = pick_rational_normal(random);
    const testing::RationalVector n = testing::exactly(surface.normal);
    EXPECT_EQ(Rational(surface.r) * Rational(surface.r), n[0] * n[0] + n[2] * n[2]);
    EXPECT_EQ(Rational(surface.length) * Rational(surface.length), testing::dot(n, n));
    EXPECT_LT(n[2], 0);
  }
}

}  // namespace
}  // namespace groundtruth::cases
