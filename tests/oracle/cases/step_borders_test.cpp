// Is each step exactly on the border that its flavour names?

#include <algorithm>
#include <variant>

#include <gtest/gtest.h>

#include <groundtruth/cases/scene_builders.hpp>
#include <groundtruth/cases/step_flavours.hpp>

#include "exact_wheel.hpp"

namespace groundtruth::cases {
namespace {

using testing::contact_of;
using testing::delta;
using testing::exactly;
using testing::for_many;
using testing::force_in_wheel;
using testing::in_wheel;
using testing::normal_in_wheel;
using testing::pebble_in_wheel;
using testing::pressure;
using testing::Rational;
using testing::RationalVector;
using testing::side_of_disc;
using testing::tries;

TEST(StepZLimits, PebbleIsExactlyAtALimit) {
  int at_min = 0, at_zero = 0, at_max = 0;
  for_many(step_z_limits, hills_of(3), [&](const StepAsk& ask) {
    const Rational z = pebble_in_wheel(ask)[2];
    at_min += z == Rational(ask.wheel.z_min);
    at_zero += z == Rational(ask.wheel.z_zero);
    at_max += z == Rational(ask.wheel.z_max);
  });
  EXPECT_EQ(at_min + at_zero + at_max, tries);
  for (int seen : {at_min, at_zero, at_max}) EXPECT_GT(seen, tries / 5);
}

TEST(StepNoPressure, NormalForceIsExactlyZeroWithinTheStrut) {
  for_many(step_no_pressure, house(), [](const StepAsk& ask) {
    EXPECT_EQ(pressure(ask), 0);
    const Rational z = pebble_in_wheel(ask)[2];
    EXPECT_GT(z, Rational(ask.wheel.z_min));
    EXPECT_LT(z, Rational(ask.wheel.z_max));
  });
}

TEST(StepGivesWay, NormalForceIsExactlyTheMost) {
  for_many(step_gives_way, runway_of(6), [](const StepAsk& ask) {
    ASSERT_TRUE(contact_of(ask).maximum_force);
    const RationalVector n = normal_in_wheel(ask);
    const Rational most(*contact_of(ask).maximum_force);
    EXPECT_GT(most, 0);
    EXPECT_GT(pressure(ask), 0);
    EXPECT_EQ(pressure(ask) * pressure(ask), most * most * testing::dot(n, n));
  });
}

TEST(StepBorder, ForceIsOftenExactlyOnTheDiscAndAlwaysPresses) {
  int on_disc = 0, inside = 0, outside = 0;
  for_many(step_border, house(), [&](const StepAsk& ask) {
    EXPECT_GT(pressure(ask), 0);
    const int side = side_of_disc(ask);
    inside += side < 0;
    on_disc += side == 0;
    outside += side > 0;
  });
  for (int seen : {inside, on_disc, outside}) EXPECT_GT(seen, tries / 8);
}

TEST(StepSteepnessLimit, IsExactOrJustBeyondForHalfOfTheAsks) {
  int exact = 0, beyond = 0;
  for_many(step_steepness_limit, runway_of(6), [&](const StepAsk& ask) {
    if (std::holds_alternative<Free>(ask.state)) return;
    const RationalVector n = normal_in_wheel(ask);
    const Rational t(ask.wheel.min_uprightness);
    const Rational slack = n[2] * n[2] - t * t * (n[0] * n[0] + n[1] * n[1]);
    EXPECT_LT(n[2], 0);
    EXPECT_LE(slack, 0);
    exact += slack == 0;
    beyond += slack < 0;
  });
  EXPECT_GT(exact, tries / 5);
  EXPECT_GT(beyond, tries / 10);
}

TEST(StepSteepnessLimit, FreeWheelOverLevelGroundIsTiltedExactlyToIt) {
  int exact = 0, free = 0;
  for_many(step_steepness_limit, runway_of(6), [&](const StepAsk& ask) {
    if (!std::holds_alternative<Free>(ask.state)) return;
    ++free;
    const RationalVector up = in_wheel(ask, exactly({0, 0, 1}));
    const Rational t(ask.wheel.min_uprightness);
    exact += up[2] < 0 && up[2] * up[2] == t * t * (up[0] * up[0] + up[1] * up[1]);
  });
  EXPECT_GT(free, tries / 3);
  EXPECT_EQ(exact, free);
}

TEST(StepLandsOnFeature, NewPebblesStrutGoesThroughAPlaneExactly) {
  const Scene scene = house();
  const std::vector<HalfSpace> planes = testing::half_spaces_of(scene.shape);
  int through_two_planes = 0;
  for_many(step_lands_on_feature, scene, [&](const StepAsk& ask) {
    EXPECT_EQ(side_of_disc(ask), 1);
    // Case 1 with |F'_y| = s: x gives way to the brake, y stays. The normal is straight up in the wheel
    // frame.
    const RationalVector f = force_in_wheel(ask);
    const Rational brake(ask.brake);
    const RationalVector landing{(f[0] < 0 ? -brake : brake) / Rational(ask.wheel.k_xy),
                                 f[1] / Rational(ask.wheel.k_xy), Rational(0)};
    const RationalVector base = exactly(ask.frame.position_in_world);
    const RationalVector arm = testing::rotated(ask.frame.world_from_wheel, landing);
    const RationalVector down = testing::rotated(ask.frame.world_from_wheel, exactly({0, 0, 1}));
    int most = 0;
    for (int step = 0; step <= 32; ++step) {
      const Rational z(step / 16.0);
      RationalVector point;
      for (std::size_t i = 0; i < 3; ++i) point[i] = base[i] + arm[i] + z * down[i];
      int touched = 0;
      for (const HalfSpace& plane : planes) touched += delta(plane, point) == 0;
      most = std::max(most, touched);
    }
    EXPECT_GE(most, 1);
    through_two_planes += most >= 2;
  });
  EXPECT_GT(through_two_planes, tries / 3);
}

}  // namespace
}  // namespace groundtruth::cases
