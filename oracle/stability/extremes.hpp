#pragma once
// Machines, grounds and steps at the ends of what doubles and the contract allow: whatever happens, every
// step is either done, with finite numbers, or says why not.

#include <functional>
#include <string>
#include <vector>

#include <groundtruth/rig/scenario.hpp>

namespace groundtruth::stability {

struct Extreme {
  std::string name;  // what is extreme
  rig::Scenario scenario;
};

// One thing at a time to each of its ends, with each integrator and relocation.
std::vector<Extreme> chosen_extremes();

// Everything at once, log-uniformly between its ends; the same for the same seed.
Extreme random_extreme(std::uint64_t seed);

struct Ordeal {
  std::string name;
  rig::Integrator integrator{};
  std::uint64_t steps = 0;  // done
  rig::Halt halt = rig::Halt::none;
  std::string reason;         // of a refusal
  bool all_is_finite = true;  // state, forces and energy, after every step
  double slowest_step_s = 0;
  double energy_rise = 0;  // the largest in a step, in parts of m g 1 m
  double border_violation = 0;
};

Ordeal ordeal_of(const Extreme& extreme, std::uint64_t steps);

}  // namespace groundtruth::stability
