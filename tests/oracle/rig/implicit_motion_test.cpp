// The implicit integrator at stiffnesses where the explicit ones blow up.

#include <cmath>

#include <gtest/gtest.h>

#include <groundtruth/tests/oracle/rig/landings.hpp>

#include "runs.hpp"

namespace groundtruth::rig {
namespace {

// A built-in scenario with springs and dampers for h omega = `stiffness`, for so many steps.
Scenario implicit_scenario(std::string_view name, double stiffness, int steps) {
  Scenario scenario = testing::builtin(name);
  const double faster = stiffness / 0.4;
  for (MountedWheel& mounted : scenario.machine.wheels) {
    mounted.wheel.k_xy *= faster * faster;
    mounted.wheel.k_z *= faster * faster;
    mounted.wheel.d_xy *= faster;
    mounted.wheel.d_z *= faster;
    mounted.wheel.relocation = Relocation::return_mapping;
  }
  scenario.integrator = Integrator::implicit;
  scenario.duration = steps * scenario.h;
  return scenario;
}

class Stiff : public ::testing::TestWithParam<double> {};

TEST_P(Stiff, TheParkedStandStillToTheBit) {
  for (const char* name : {"parked-10", "parked-one-10"}) {
    const Summary summary = play(implicit_scenario(name, GetParam(), 800), "fast");
    EXPECT_EQ(summary.outcome, Halt::none) << name;
    EXPECT_EQ(summary.pebble_drift_m, 0) << name;
    EXPECT_LE(summary.border_violation, 1e-9) << name;
    EXPECT_LE(summary.energy_rise, 1e-12) << name;
  }
}

TEST_P(Stiff, StopsKeepTheBorderAndEnergyFalls) {
  for (const char* name : {"stop-dry", "slide"}) {
    const Summary summary = play(implicit_scenario(name, GetParam(), 600), "fast");
    EXPECT_EQ(summary.outcome, Halt::none) << name;
    EXPECT_GT(summary.wheel_steps_slip, 1000U) << name;
    EXPECT_LE(summary.border_violation, 1e-9) << name;
    EXPECT_LE(summary.energy_rise, 1e-12) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(HeaveTimesH, Stiff, ::testing::Values(0.4, 4.0, 40.0, 400.0));

// A free fall of the step's length ends below the struts' stops.
TEST(ImplicitMotion, HalfASecondsStepTouchesDownAndStands) {
  Scenario scenario = testing::builtin("parked-5");
  scenario.integrator = Integrator::implicit;
  scenario.h = 0.5;
  scenario.duration = 600;
  const Summary summary = play(scenario, "fast");
  EXPECT_EQ(summary.outcome, Halt::none);
  EXPECT_EQ(summary.wheel_steps_stick, 3600U);
  EXPECT_EQ(summary.pebble_drift_m, 0);
}

TEST(ImplicitMotion, EveryStepOfLandingsOnThreeWheelsIsSolved) {
  for (const Relocation relocation : {Relocation::spring, Relocation::return_mapping}) {
    properties::Dice dice(1);
    for (int i = 0; i < 150; ++i) {
      const LandingKind kind{stability::Wheels::three, Integrator::implicit, relocation};
      const Summary summary = play(random_landing(kind, 100, dice), "fast");
      EXPECT_NE(summary.outcome, Halt::not_solved) << i;
      EXPECT_LE(summary.border_violation, 1e-9) << i;
    }
  }
}

TEST(ImplicitMotion, AMirroredStartGivesTheMirroredRunToTheBit) {
  Scenario scenario = implicit_scenario("stop-dry", 0.4, 200);
  scenario.start.velocity_in_world.y() = 3;
  Scenario image = scenario;
  image.start.velocity_in_world.y() = -3;
  for (MountedWheel& mounted : image.machine.wheels) mounted.place_in_body.y() *= -1;
  for (const Integrator integrator : {Integrator::semi_implicit, Integrator::implicit}) {
    scenario.integrator = image.integrator = integrator;
    const auto run = testing::run_of(scenario), mirrored = testing::run_of(image);
    ASSERT_EQ(run.states.size(), mirrored.states.size());
    for (std::size_t i = 0; i < run.states.size(); ++i) {
      const BodyState &one = run.states[i].body, &other = mirrored.states[i].body;
      ASSERT_EQ(one.position_in_world.x(), other.position_in_world.x()) << i;
      ASSERT_EQ(one.position_in_world.y(), -other.position_in_world.y()) << i;
      ASSERT_EQ(one.position_in_world.z(), other.position_in_world.z()) << i;
      ASSERT_EQ(one.angular_velocity_in_world.z(), -other.angular_velocity_in_world.z()) << i;
    }
  }
}

}  // namespace
}  // namespace groundtruth::rig
