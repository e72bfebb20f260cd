#include <groundtruth/tests/oracle/rig/lockstep.hpp>

#include <gtest/gtest.h>

#include <groundtruth/tests/oracle/rig/random_scenarios.hpp>

namespace groundtruth::rig {
namespace {

// A short version of the command `lockstep`.
TEST(Lockstep, FastTakesTheExactStatesAndForcesAtEveryStepOfRandomRuns) {
  properties::Dice dice(20261126);
  Lockstep lockstep;
  for (int i = 0; i < 60; ++i) lockstep.add(lockstep_of(random_scenario(dice), 60));
  EXPECT_EQ(lockstep.differences, 0U) << lockstep.first_difference;
  EXPECT_GT(lockstep.wheel_steps, 4000U);
  EXPECT_GT(lockstep.slip_steps, 500U);
}

}  // namespace
}  // namespace groundtruth::rig
