// lockstep WHEEL_STEPS [SEED]: `exact` and `fast` in lockstep over random scenarios, until so many wheel
// steps have been compared. Exit 1 on any difference.

#include <cstdlib>

#include <fmt/core.h>

#include <groundtruth/tests/oracle/rig/lockstep.hpp>
#include <groundtruth/tests/oracle/rig/random_scenarios.hpp>

int main(int argc, char** argv) {
  using namespace groundtruth;
  const std::uint64_t wanted = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1000000;
  properties::Dice dice(argc > 2 ? std::strtoull(argv[2], nullptr, 10) : std::uint64_t{1});
  rig::Lockstep all;
  std::uint64_t scenarios = 0;
  for (; all.wheel_steps < wanted; ++scenarios) {
    all.add(rig::lockstep_of(rig::random_scenario(dice), 400));
    if (scenarios % 100 == 99) fmt::print(stderr, "{} wheel steps\n", all.wheel_steps);
  }
  fmt::print("{} scenarios, {} wheel steps compared, {} of them slips; {} differ, worst force {:g} ulps\n",
             scenarios, all.wheel_steps, all.slip_steps, all.differences, all.worst_force_ulps);
  if (all.differences != 0) fmt::print("{}\n", all.first_difference);
  return all.differences == 0 ? 0 : 1;
}
