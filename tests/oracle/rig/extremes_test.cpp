// A short version of `groundtruth stability`.

#include <gtest/gtest.h>

#include <groundtruth/stability/extremes.hpp>
#include <groundtruth/stability/map.hpp>

namespace groundtruth::stability {
namespace {

// A run that stopped without a reason, or went on with numbers that are none, or friction beyond its border.
bool is_unsound(const Ordeal& ordeal, std::uint64_t steps) {
  return !ordeal.all_is_finite || ordeal.border_violation > 1e-9 ||
         (ordeal.halt == rig::Halt::none && ordeal.steps != steps) ||
         (ordeal.halt == rig::Halt::refused && ordeal.reason.empty());
}

TEST(Extremes, EveryStepIsDoneWithFiniteNumbersOrSaysWhyNot) {
  for (const Extreme& extreme : chosen_extremes())
    EXPECT_FALSE(is_unsound(ordeal_of(extreme, 40), 40)) << extreme.name;
}

TEST(Extremes, SoDoRandomOnes) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed)
    EXPECT_FALSE(is_unsound(ordeal_of(random_extreme(seed), 40), 40)) << seed;
}

// One wheel stands where the slope is less than the tyre's upright limit, 10, and not where it is more.
TEST(Extremes, TheUprightLimitIsReached) {
  int ran = 0, too_steep = 0;
  for (const Extreme& extreme : chosen_extremes()) {
    if (extreme.scenario.machine.wheels.size() != 1) continue;
    const rig::Halt halt = ordeal_of(extreme, 2).halt;
    ran += extreme.name == "slope 9.99 under a level machine" && halt == rig::Halt::none;
    too_steep += extreme.name == "slope 10.01 under a level machine" && halt == rig::Halt::surface_too_steep;
  }
  EXPECT_EQ(ran, 6);
  EXPECT_EQ(too_steep, 6);
}

TEST(StabilityMap, ExplicitIntegratorsStandStillBelowTheLimit) {
  for (const Wheels wheels : {Wheels::one, Wheels::three}) {
    Parked parked{wheels, 0.8 * explicit_limit(wheels, 0.3), 0.3};
    EXPECT_EQ(cell_of(parked, 3000).fate, Fate::settled);
    parked.h_omega = 1.2 * explicit_limit(wheels, 0.3);
    EXPECT_NE(cell_of(parked, 3000).fate, Fate::settled);
  }
}

// Times the explicit limit: 10,000 on one wheel, 1,000 on three.
TEST(StabilityMap, TheImplicitIntegratorStandsStillFarAboveIt) {
  for (const auto& [wheels, times] : {std::pair{Wheels::one, 1e4}, {Wheels::three, 1e3}})
    for (const double slope : {0.05, 0.1})
      for (const double damping : {0.0, 0.1, 0.3, 1.0}) {
        const Parked parked{wheels,
                            times * explicit_limit(wheels, damping),
                            damping,
                            slope,
                            rig::Integrator::implicit,
                            Relocation::return_mapping};
        const Cell cell = cell_of(parked, 500);
        EXPECT_EQ(cell.fate, Fate::settled) << parked.h_omega;
        EXPECT_LE(cell.energy_rise, 1e-11) << "rounding at " << parked.h_omega;
      }
}

TEST(StabilityMap, TheLimitIsTheKnownOne) {
  EXPECT_DOUBLE_EQ(explicit_limit(Wheels::one, 0), 2);
  EXPECT_NEAR(explicit_limit(Wheels::one, 1), 0.8284271247461903, 1e-15);
}

}  // namespace
}  // namespace groundtruth::stability
