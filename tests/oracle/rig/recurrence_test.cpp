#include <groundtruth/rig/recurrence.hpp>

#include <gtest/gtest.h>

namespace groundtruth::rig {
namespace {

// A motion that goes through `lead` states once and then round through `round` others.
std::optional<std::uint64_t> period_found(std::uint64_t lead, std::uint64_t round, std::uint64_t steps) {
  Recurrence recurrence;
  for (std::uint64_t step = 1; step <= steps; ++step) {
    MotionState state{{}, {Free{}}, step};
    state.body.position_in_world.x() = static_cast<double>(step < lead ? step : lead + (step - lead) % round);
    if (const auto period = recurrence.period_at(state)) return period;
  }
  return std::nullopt;
}

TEST(Recurrence, FindsTheShortestRound) {
  for (const std::uint64_t lead : {0u, 1u, 5u, 100u})
    for (const std::uint64_t round : {1u, 2u, 3u, 17u, 64u})
      EXPECT_EQ(period_found(lead, round, 2000), round);
}

TEST(Recurrence, SeesNoneInAMotionThatGoesOn) { EXPECT_EQ(period_found(100000, 1, 5000), std::nullopt); }

TEST(Recurrence, AWheelsStateIsPartOfTheState) {
  Recurrence recurrence;
  MotionState state{{}, {Contact{}}, 1};
  EXPECT_FALSE(recurrence.period_at(state));
  ++state.steps;
  std::get<Contact>(state.wheels[0]).pebble_velocity_in_world[2] = 0x1p-1074;
  EXPECT_FALSE(recurrence.period_at(state));
  ++state.steps;
  EXPECT_FALSE(recurrence.period_at(state)) << "is remembered now";
  ++state.steps;
  EXPECT_EQ(recurrence.period_at(state), 1U);
}

}  // namespace
}  // namespace groundtruth::rig
