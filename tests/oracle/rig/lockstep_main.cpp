// lockstep [STEPS [WHEEL_STEPS [SEED]]]: `exact` and `fast` in lockstep, over every built-in scenario with
// each integrator and relocation, for STEPS steps (15,000) or to its end; then over random scenarios until so
// many wheel steps (300,000) have been compared. Exit 1 on any difference.

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/core.h>

#include <groundtruth/rig/builtin_scenarios.hpp>
#include <groundtruth/tests/oracle/rig/lockstep.hpp>
#include <groundtruth/tests/oracle/rig/random_scenarios.hpp>

namespace {

using namespace groundtruth;

void print(const std::string& name, const rig::Lockstep& lockstep) {
  fmt::print("{:<16}{:>12}{:>12}{:>12}{:>12g}\n", name, lockstep.wheel_steps, lockstep.slip_steps,
             lockstep.differences, lockstep.worst_ulps);
  std::fflush(stdout);
}

rig::Lockstep over_variants(const rig::Scenario& scenario, long most_steps) {
  const long steps = std::min(most_steps, std::lround(scenario.duration / scenario.h));
  rig::Lockstep all;
  for (const rig::Scenario& variant : rig::variants_of(scenario))
    all.add(rig::lockstep_of(variant, static_cast<int>(steps)));
  return all;
}

rig::Lockstep over_random_ones(std::uint64_t wheel_steps, std::uint64_t seed) {
  properties::Dice dice(seed);
  rig::Lockstep all;
  while (all.wheel_steps < wheel_steps) all.add(rig::lockstep_of(rig::random_scenario(dice), 400));
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  const long most_steps = argc > 1 ? std::strtol(argv[1], nullptr, 10) : 15000;
  const std::uint64_t random_steps = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 300000;
  const std::uint64_t seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
  fmt::print("{:<16}{:>12}{:>12}{:>12}{:>12}\n", "scenario", "wheel steps", "slips", "differ", "worst ulps");
  rig::Lockstep all;
  for (const rig::Scenario& scenario : rig::builtin_scenarios()) {
    const rig::Lockstep one = over_variants(scenario, most_steps);
    print(scenario.name, one);
    all.add(one);
  }
  const rig::Lockstep random = over_random_ones(random_steps, seed);
  print("random", random);
  all.add(random);
  print("all", all);
  if (all.differences != 0) fmt::print("{}\n", all.first_difference);
  return all.differences == 0 ? 0 : 1;
}
