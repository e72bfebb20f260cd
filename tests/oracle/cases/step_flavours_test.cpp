// Is each step exactly on the border that its flavour names? Here z is measured in the wheel frame, with the
// rational rotation of section 1.

#include <algorithm>
#include <cmath>
#include <variant>

#include <gtest/gtest.h>

#include <groundtruth/cases/scene_builders.hpp>
#include <groundtruth/cases/step_flavours.hpp>
#include <groundtruth/cases/step_parts.hpp>

#include "exact_checks.hpp"

namespace groundtruth::cases {
namespace {

using testing::delta;
using testing::exactly;
using testing::minus;
using testing::Rational;
using testing::RationalVector;

constexpr int tries = 200;

template <class Check>
void for_many(StepAsk (*make)(const Landmarks&, Random&), const Scene& scene, Check check) {
  const Landmarks landmarks = survey(scene);
  for (std::uint64_t i = 0; i < tries; ++i) {
    Random random(i);
    SCOPED_TRACE(i);
    check(make(landmarks, random));
  }
}

RationalVector in_wheel(const StepAsk& ask, const RationalVector& direction_in_world) {
  return testing::rotated(testing::inverse(ask.frame.world_from_wheel), direction_in_world);
}

const Contact& contact_of(const StepAsk& ask) { return std::get<Contact>(ask.state); }

RationalVector pebble_in_wheel(const StepAsk& ask) {
  return in_wheel(ask, minus(exactly(contact_of(ask).pebble_in_world), exactly(ask.frame.position_in_world)));
}

RationalVector normal_in_wheel(const StepAsk& ask) {
  return in_wheel(ask, exactly(contact_of(ask).normal_in_world));
}

// The force law of section 5.
RationalVector force_in_wheel(const StepAsk& ask) {
  const RationalVector pebble = pebble_in_wheel(ask);
  const RationalVector arm =
      minus(exactly(contact_of(ask).pebble_in_world), exactly(ask.frame.position_in_world));
  const RationalVector turning = testing::cross(exactly(ask.frame.angular_velocity_in_world), arm);
  const RationalVector velocity = in_wheel(ask, minus(minus(exactly(contact_of(ask).pebble_velocity_in_world),
                                                            exactly(ask.frame.velocity_in_world)),
                                                      turning));
  const Wheel& w = ask.wheel;
  return {Rational(w.k_xy) * pebble[0] + Rational(w.d_xy) * velocity[0],
          Rational(w.k_xy) * pebble[1] + Rational(w.d_xy) * velocity[1],
          Rational(w.k_z) * (pebble[2] - Rational(w.z_zero)) + Rational(w.d_z) * velocity[2]};
}

// F'_z |n|, which has the sign of F'_z.
Rational pressure(const StepAsk& ask) { return -testing::dot(force_in_wheel(ask), normal_in_wheel(ask)); }

// -1, 0, 1: inside, on, outside the disc of the friction that counts.
int side_of_disc(const StepAsk& ask) {
  const RationalVector f = force_in_wheel(ask);
  const RationalVector n = normal_in_wheel(ask);
  const Rational n_squared = testing::dot(n, n);
  const Rational down = testing::dot(f, n);
  const Contact& contact = contact_of(ask);
  const Rational mu(contact.grip == Grip::stick ? contact.static_friction : contact.dynamic_friction);
  const Rational across = testing::dot(f, f) - down * down / n_squared;
  const Rational most = mu * mu * down * down / n_squared;
  return across < most ? -1 : across == most ? 0 : 1;
}

// A point on the axis of the strut, in the world.
RationalVector on_strut(const StepAsk& ask, double z) {
  const RationalVector arm =
      testing::rotated(ask.frame.world_from_wheel, RationalVector{Rational(0), Rational(0), Rational(z)});
  const RationalVector base = exactly(ask.frame.position_in_world);
  return {base[0] + arm[0], base[1] + arm[1], base[2] + arm[2]};
}

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
  for_many(step_unknown_tyre, house(), [](const StepAsk& ask) { EXPECT_EQ(ask.wheel.tyre, "wood"); });
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
