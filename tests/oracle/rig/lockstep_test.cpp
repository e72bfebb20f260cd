#include <groundtruth/tests/oracle/rig/lockstep.hpp>

#include <gtest/gtest.h>

#include <groundtruth/rig/builtin_scenarios.hpp>
#include <groundtruth/tests/oracle/rig/random_scenarios.hpp>

namespace groundtruth::rig {
namespace {

// Short versions of the command `lockstep`.
TEST(Lockstep, FastTakesTheExactStatesAndForcesAtEveryStepOfRandomRuns) {
  properties::Dice dice(20261126);
  Lockstep lockstep;
  for (int i = 0; i < 60; ++i) lockstep.add(lockstep_of(random_scenario(dice), 60));
  EXPECT_EQ(lockstep.differences, 0U) << lockstep.first_difference;
  EXPECT_GT(lockstep.wheel_steps, 4000U);
  EXPECT_GT(lockstep.slip_steps, 500U);
}

TEST(Lockstep, FastTakesTheExactStatesAndForcesInEveryBuiltinScenario) {
  for (const Scenario& scenario : builtin_scenarios())
    for (const Scenario& variant : variants_of(scenario)) {
      const Lockstep lockstep = lockstep_of(variant, 100);
      EXPECT_EQ(lockstep.differences, 0U) << lockstep.first_difference;
      EXPECT_GT(lockstep.wheel_steps, 0U) << scenario.name;
    }
}

TEST(Lockstep, BeginsInTheContactsThatAScenarioStartsWith) {
  EXPECT_EQ(lockstep_of(*find_builtin_scenario("stop-one"), 1).slip_steps, 1U);
}

// A step whose free fall ends below the struts' stops: the integrator asks for entry points too.
TEST(Lockstep, ComparesEntryPointsThatTheImplicitIntegratorAsksFor) {
  Scenario scenario = *find_builtin_scenario("parked-5");
  scenario.integrator = Integrator::implicit;
  scenario.h = 0.5;
  const Lockstep lockstep = lockstep_of(scenario, 3);
  EXPECT_EQ(lockstep.differences, 0U) << lockstep.first_difference;
  EXPECT_GE(lockstep.wheel_steps, 9U);
}

TEST(Lockstep, SeesThatPlainDoublesRoundForces) {
  const Lockstep lockstep = lockstep_of(*find_builtin_scenario("slide"), 100, "double");
  EXPECT_GT(lockstep.differences, 100U);
  EXPECT_GT(lockstep.worst_ulps, 0);
  EXPECT_FALSE(lockstep.first_difference.empty());
}

}  // namespace
}  // namespace groundtruth::rig
