// Do the wheels do what their flavour says?

#include <algorithm>
#include <cmath>
#include <variant>

#include <gtest/gtest.h>

#include <groundtruth/cases/scene_builders.hpp>
#include <groundtruth/cases/step_flavours.hpp>
#include <groundtruth/cases/step_parts.hpp>

#include "exact_wheel.hpp"

namespace groundtruth::cases {
namespace {

using testing::contact_of;
using testing::delta;
using testing::exactly;
using testing::for_many;
using testing::on_strut;
using testing::pressure;
using testing::RationalVector;
using testing::side_of_disc;
using testing::tries;

TEST(StepFree, StrutCrossesAPlaneWhenItHitsAndMostlyNoneWhenItMisses) {
  const Scene scene = runway_of(6);
  const HalfSpace top{{0, 0, 1}, 0};
  const auto crosses_top = [&](const StepAsk& ask) {
    return delta(top, on_strut(ask, ask.wheel.z_min)) > 0 && delta(top, on_strut(ask, ask.wheel.z_max)) <= 0;
  };
  int hits = 0, misses = 0;
  for_many(step_free_hit, scene, [&](const StepAsk& ask) { hits += crosses_top(ask); });
  for_many(step_free_miss, scene, [&](const StepAsk& ask) { misses += !crosses_top(ask); });
  EXPECT_GT(hits, tries / 2);
  EXPECT_GT(misses, tries * 9 / 10);
}

TEST(StepFreeLimits, OneEndOfTheStrutIsExactlyOnAPlane) {
  const Scene scene = house();
  const std::vector<HalfSpace> planes = testing::half_spaces_of(scene.shape);
  int at_start = 0, at_end = 0;
  for_many(step_free_limits, scene, [&](const StepAsk& ask) {
    const auto touches = [&](double z) {
      const RationalVector end = on_strut(ask, z);
      for (const HalfSpace& plane : planes) {
        if (delta(plane, end) == 0) return true;
      }
      return false;
    };
    const bool starts = touches(ask.wheel.z_min);
    const bool ends = touches(ask.wheel.z_max);
    EXPECT_TRUE(starts || ends);
    at_start += starts;
    at_end += ends;
  });
  EXPECT_GT(at_start, tries / 4);
  EXPECT_GT(at_end, tries / 4);
}

TEST(StepResting, MostWheelsAreBorne) {
  int borne = 0;
  for_many(step_resting, house(),
           [&](const StepAsk& ask) { borne += pressure(ask) > 0 && side_of_disc(ask) < 0; });
  EXPECT_GT(borne, tries / 2);
}

TEST(StepSkidding, MostWheelsSlip) {
  int slipping = 0;
  for_many(step_skidding, house(),
           [&](const StepAsk& ask) { slipping += pressure(ask) > 0 && side_of_disc(ask) > 0; });
  EXPECT_GT(slipping, tries * 3 / 4);
}

TEST(StepTurning, HasAngularVelocity) {
  for_many(step_turning, house(),
           [](const StepAsk& ask) { EXPECT_NE(ask.frame.angular_velocity_in_world, Vector{}); });
}

TEST(StepWheels, BothRelocationsTyresAndGripsCome) {
  int spring = 0, metal = 0, stick = 0;
  for_many(step_skidding, house(), [&](const StepAsk& ask) {
    spring += ask.wheel.relocation == Relocation::spring;
    metal += ask.wheel.tyre == "metal";
    stick += contact_of(ask).grip == Grip::stick;
  });
  EXPECT_NEAR(spring, tries / 2, tries / 5);
  EXPECT_NEAR(stick, tries / 2, tries / 5);
  EXPECT_GT(metal, 10);
}

TEST(StepUnknownTyre, IsOfNoMaterial) {
  for_many(step_unknown_tyre, house(), [](const StepAsk& ask) {
    for (const Material& material : house().materials)
      EXPECT_EQ(material.friction_by_tyre.count(ask.wheel.tyre), 0U) << ask.wheel.tyre;
  });
}

TEST(StepParts, UprightWheelLooksAgainstTheNormal) {
  Random random(1);
  for (const Vector& n :
       {Vector{0, 0, 1}, Vector{-1, 0, 4}, Vector{3, 4, 5}, Vector{0, 0, -1}, Vector{1, 0, 0}}) {
    for (int i = 0; i < 100; ++i) {
      const Quaternion q = upright_on(n, random);
      ASSERT_NE(q, Quaternion{});
      const Vector down = rotated(q, {0, 0, 1});
      const double size = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
      EXPECT_LT((down[0] * n[0] + down[1] * n[1] + down[2] * n[2]) / size, -0.85);
    }
  }
}

TEST(StepParts, RightAngleOrientationsTakeAxesToAxesExactly) {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const Quaternion q = right_angle_orientation(random);
    const Vector turned = rotated(q, {1, 2, 3});
    const RationalVector exact = testing::rotated(q, exactly({1, 2, 3}));
    EXPECT_EQ(exactly(turned), exact);
    Vector sizes{std::abs(turned[0]), std::abs(turned[1]), std::abs(turned[2])};
    std::sort(sizes.begin(), sizes.end());
    EXPECT_EQ(sizes, (Vector{1, 2, 3}));
  }
}

}  // namespace
}  // namespace groundtruth::cases
