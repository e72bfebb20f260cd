#pragma once
// `exact` and another engine fed with the same asks all along a motion.

#include <cstdint>
#include <string>
#include <vector>

#include <groundtruth/rig/scenario.hpp>

namespace groundtruth::rig {

struct Lockstep {
  std::uint64_t wheel_steps = 0;  // compared
  std::uint64_t slip_steps = 0;   // of these, how many ended in slip
  std::uint64_t differences = 0;  // in outcome, state, or a bit of a number
  // Of force, pebble, or its velocity, in units of the last place of the vector's largest component.
  double worst_ulps = 0;
  std::string first_difference;  // the scene and the ask; empty if there is none

  void add(const Lockstep& other);
};

// Sets the scenario in motion on `exact` and asks the other engine the same at every wheel step, as long as
// the motion goes on, for at most so many steps. If all answers are alike, so is the motion on that engine.
Lockstep lockstep_of(const Scenario& scenario, int steps, const std::string& engine = "fast");

// The scenario with each integrator and each relocation.
std::vector<Scenario> variants_of(const Scenario& scenario);

}  // namespace groundtruth::rig
