// Does every built-in scenario do what its name says?

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "runs.hpp"

namespace groundtruth::rig {
namespace {

using testing::builtin;
using testing::contact_of;
using testing::has_grip;
using testing::is_airborne;
using testing::Playback;
using testing::run_of;

constexpr double g = 9.81;

double speed_of(const MotionState& state) { return state.body.velocity_in_world.norm(); }

TEST(BuiltinScenarios, HaveDistinctNamesAndOneLineDescriptions) {
  std::vector<std::string> names;
  for (const Scenario& scenario : builtin_scenarios()) {
    names.push_back(scenario.name);
    EXPECT_FALSE(scenario.description.empty());
    EXPECT_EQ(scenario.description.find('\n'), std::string::npos);
  }
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::unique(names.begin(), names.end()), names.end());
  EXPECT_EQ(find_builtin_scenario("nowhere"), nullptr);
}

TEST(BuiltinScenarios, TheParkedStayWhereTheyAre) {
  for (const char* name : {"parked-5", "parked-10", "parked-one-5", "parked-one-10"}) {
    Scenario scenario = builtin(name);
    scenario.duration = 60;
    const Summary summary = play(scenario, "fast");
    EXPECT_EQ(summary.outcome, Halt::none) << name;
    EXPECT_EQ(summary.pebble_drift_m, 0) << name;
    EXPECT_LE(summary.body_drift_m, 1e-15) << name;
    EXPECT_EQ(summary.wheel_steps_slip, 0U) << name;
  }
}

TEST(BuiltinScenarios, TheYearOfParkingRepeatsItselfToTheBit) {
  const Summary summary = play(builtin("parked-year"), "fast");
  EXPECT_EQ(summary.steps, 1893456000U);
  EXPECT_EQ(summary.pebble_drift_m, 0);
  EXPECT_EQ(summary.body_drift_m, 0);
  ASSERT_TRUE(summary.recurrence.has_value());
  EXPECT_LT(summary.recurrence->first, 10000U);
}

TEST(BuiltinScenarios, CrosswindPushesButMovesNoPebble) {
  Scenario scenario = builtin("crosswind");
  scenario.duration = 10;
  const Playback run = run_of(scenario);
  EXPECT_EQ(run.summary.pebble_drift_m, 0);
  EXPECT_EQ(run.summary.wheel_steps_slip, 0U);
  const auto y = [](const MotionState& state) { return state.body.position_in_world.y(); };
  const auto [least, greatest] =
      std::minmax_element(run.states.begin() + 1200, run.states.end(),
                          [&](const MotionState& a, const MotionState& b) { return y(a) < y(b); });
  EXPECT_LT(y(*greatest), -1e-4) << "leans with the wind";
  EXPECT_GT(y(*greatest) - y(*least), 1e-4) << "trembles";
}

// Of the last second, relative to g (sin - mu cos) less mu a, where a is what the body gains away from the
// slope: loads bear that too.
struct SlideErrors {
  double of_slide = 0;
  double of_balance = 0;
};

SlideErrors slide_errors(const Scenario& scenario) {
  const Playback run = run_of(scenario);
  EXPECT_EQ(run.summary.outcome, Halt::none);
  EXPECT_EQ(run.states.back().body.position_in_world.y(), 0);
  const double cosine = 1 / std::hypot(1, 0.6), sine = 0.6 * cosine;
  const std::size_t last = run.states.size() - 1,
                    first = last - static_cast<std::size_t>(std::llround(1 / scenario.h));
  const Eigen::Vector3d gained =
      (run.states[last].body.velocity_in_world - run.states[first].body.velocity_in_world) /
      (static_cast<double>(last - first) * scenario.h);
  const double along = gained.dot(Eigen::Vector3d(cosine, 0, -sine));
  const double away = gained.dot(Eigen::Vector3d(sine, 0, cosine));
  return {std::abs(along / (g * (sine - 0.4 * cosine)) - 1),
          std::abs(along / (g * sine - 0.4 * (g * cosine + away)) - 1)};
}

TEST(BuiltinScenarios, SlideAcceleratesByTheClosedForm) {
  Scenario scenario = builtin("slide");
  const SlideErrors turning = slide_errors(scenario);
  EXPECT_LE(turning.of_balance, 1e-13);
  EXPECT_LE(turning.of_slide, 1e-10) << "the pebbles' lag v h grows, the body pitches with it and sinks";
  scenario.h /= 2;
  EXPECT_NEAR(turning.of_slide / slide_errors(scenario).of_slide, 4, 0.1) << "second order";
  scenario.machine.inertia.setConstant(std::numeric_limits<double>::infinity());
  EXPECT_LE(slide_errors(scenario).of_slide, 1e-12) << "three wheels, but no pitch";
}

TEST(BuiltinScenarios, TiltSlipsAtTheFrictionAtRestAndGoesOnAtThatOfSliding) {
  const Scenario scenario = builtin("tilt");
  const Playback run = run_of(scenario);
  std::size_t slip = 0;
  while (!has_grip(run.states.at(slip), Grip::slip)) ++slip;
  const double tangent = -scenario.inputs.at(run.times[slip] - scenario.h).gravity_in_world.x() / g;
  EXPECT_NEAR(tangent, 0.5, 2 * 0.01 * scenario.h) << "within two steps";
  const auto sticks = std::count_if(run.states.begin() + static_cast<std::ptrdiff_t>(slip), run.states.end(),
                                    [](const MotionState& state) { return has_grip(state, Grip::stick); });
  EXPECT_LE(sticks, 3) << "sliding friction is less: it does not hold again";
  EXPECT_GT(speed_of(run.states.back()), 5);
}

TEST(BuiltinScenarios, StopsTakeTheLengthThatFrictionGives) {
  for (const auto& [name, friction] : {std::pair{"stop-dry", 0.4}, {"stop-wet", 0.1}}) {
    const Playback run = run_of(builtin(name));
    EXPECT_NEAR(run.states.back().body.position_in_world.x() / (900 / (2 * friction * g)), 1, 1e-3) << name;
    EXPECT_LT(speed_of(run.states.back()), 1e-6) << name;
    for (const MotionState& state : run.states) {
      ASSERT_EQ(state.body.position_in_world.y(), 0);
      ASSERT_EQ(state.body.velocity_in_world.y(), 0);
      ASSERT_EQ(state.body.angular_velocity_in_world.x(), 0);
      ASSERT_EQ(state.body.angular_velocity_in_world.z(), 0);
    }
  }
  const Scenario one = builtin("stop-one");
  double furthest = 0;
  for (const MotionState& state : run_of(one).states)
    furthest = std::max(furthest, state.body.position_in_world.x());
  EXPECT_NEAR(furthest, 900 / (2 * 0.4 * g), 0.4 * g * one.h * one.h);
}

TEST(BuiltinScenarios, StopPaintHardlyBrakesOnceOnTheIce) {
  const Playback run = run_of(builtin("stop-paint"));
  const auto on_ice = std::find_if(run.states.begin(), run.states.end(), [](const MotionState& state) {
    return state.body.position_in_world.x() > 52;
  });
  ASSERT_NE(on_ice, run.states.end());
  EXPECT_NEAR(speed_of(*on_ice), std::sqrt(900 - 2 * 0.4 * g * 50), 0.5);
  EXPECT_NEAR(speed_of(run.states.back()), speed_of(*on_ice), 0.1);
  EXPECT_EQ(contact_of(run.states.back().wheels[0])->dynamic_friction, 0.001);
}

TEST(BuiltinScenarios, OneOnIceTurnsToTheSideThatHolds) {
  const Playback run = run_of(builtin("one-on-ice"));
  const MotionState& state = run.states[240];
  EXPECT_EQ(contact_of(state.wheels[1])->dynamic_friction, 0.001);
  EXPECT_EQ(contact_of(state.wheels[2])->dynamic_friction, 0.4);
  EXPECT_LT(state.body.angular_velocity_in_world.z(), -0.1) << "to the right, seen from above";
}

TEST(BuiltinScenarios, LandingsTouchBounceAndTouchAgain) {
  for (int sink = 1; sink <= 6; ++sink) {
    const Scenario scenario = builtin("land-" + std::to_string(sink));
    EXPECT_EQ(scenario.start.velocity_in_world.z(), -sink);
    const Playback run = run_of(scenario);
    EXPECT_EQ(run.summary.outcome, Halt::none);
    int touches = 0;
    bool was_airborne = true;
    for (const MotionState& state : run.states) {
      touches += was_airborne && !is_airborne(state);
      was_airborne = is_airborne(state);
    }
    EXPECT_GE(touches, 2) << sink;
    EXPECT_FALSE(was_airborne) << sink;
  }
}

TEST(BuiltinScenarios, SeamTouchesDownOnTheSeamToTheLastBit) {
  const Playback run = run_of(builtin("seam"));
  const auto touch = std::find_if(run.states.begin(), run.states.end(),
                                  [](const MotionState& state) { return !is_airborne(state); });
  ASSERT_NE(touch, run.states.end());
  for (const std::size_t wheel : {1u, 2u}) {
    ASSERT_NE(contact_of(touch->wheels[wheel]), nullptr);
    EXPECT_EQ(contact_of(touch->wheels[wheel])->pebble_in_world[0], 0);
  }
  EXPECT_NEAR(run.states.back().body.position_in_world.z(), 1.1 - g / (24 * 24), 1e-3);
}

TEST(BuiltinScenarios, EdgeLeavesTheGroundForGood) {
  const Playback run = run_of(builtin("edge"));
  EXPECT_FALSE(is_airborne(run.states[100]));
  EXPECT_TRUE(is_airborne(run.states.back()));
  EXPECT_GT(run.states.back().body.position_in_world.x(), 10);
  EXPECT_LT(run.states.back().body.position_in_world.z(), 0);
}

TEST(BuiltinScenarios, OverloadBreaksAWheelAndSoftGroundGivesWay) {
  EXPECT_EQ(play(builtin("overload"), "fast").outcome, Halt::wheel_broken);
  const Summary soft = play(builtin("soft"), "fast");
  EXPECT_EQ(soft.outcome, Halt::surface_gave_way);
  EXPECT_LT(soft.duration_s, 4);
}

TEST(BuiltinScenarios, TheExactEngineGoesThroughTheSameStates) {
  for (const char* name : {"land-3", "seam", "one-on-ice"}) {
    Scenario scenario = builtin(name);
    scenario.duration = 0.5;
    const Playback fast = run_of(scenario), exact = run_of(scenario, "exact");
    ASSERT_EQ(fast.states.size(), exact.states.size());
    for (std::size_t i = 0; i < fast.states.size(); ++i)
      ASSERT_EQ(fast.states[i].wheels, exact.states[i].wheels) << name << " step " << i;
  }
}

}  // namespace
}  // namespace groundtruth::rig
