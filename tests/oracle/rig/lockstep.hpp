#pragma once
// `exact` and `fast` fed with the same asks all along a motion.

#include <cstdint>
#include <string>

#include <groundtruth/rig/scenario.hpp>

namespace groundtruth::rig {

struct Lockstep {
  std::uint64_t wheel_steps = 0;  // compared
  std::uint64_t slip_steps = 0;   // of these, how many ended in slip
  std::uint64_t differences = 0;  // in outcome, state, or a bit of a number
  double worst_force_ulps = 0;    // in units of the last place of the force's largest component
  std::string first_difference;   // the scene and the ask; empty if there is none

  void add(const Lockstep& other);
};

// Sets the scenario in motion on `exact` and asks `fast` the same at every wheel step, as long as the motion
// goes on, for at most so many steps.
Lockstep lockstep_of(const Scenario& scenario, int steps);

}  // namespace groundtruth::rig
