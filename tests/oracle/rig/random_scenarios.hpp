#pragma once
// Machines, grounds and inputs for the laws of motion, as wide as keeps most of them rolling.

#include <cstdint>

#include <groundtruth/rig/scenario.hpp>
#include <groundtruth/tests/properties/dice.hpp>

namespace groundtruth::rig {

// One wheel that does not turn, or three on a body that does; level ground, a ramp, or a plain with a box and
// a patch of ice on it; at rest, rolling, sliding or falling; brake, steering, thrust and wind that may
// change.
Scenario random_scenario(properties::Dice& dice);

// The same, upright on a level plain, on one wheel, driven by weight and brake alone.
Scenario random_level_scenario(properties::Dice& dice);

// In the mirror y -> -y.
Scenario mirrored(const Scenario& scenario);
MotionState mirrored(const MotionState& state);

// In other units of length, time and mass: numbers times these powers of two. Friction and angles stay.
struct Units {
  double length = 1, time = 1, mass = 1;
};
Scenario in_units(const Scenario& scenario, const Units& units);
MotionState in_units(const MotionState& state, const Units& units);

// The states after each of so many steps, until the motion halts.
std::vector<MotionState> run_of(const Scenario& scenario, const std::string& engine, int steps);

bool is_same(const MotionState& a, const MotionState& b);

}  // namespace groundtruth::rig
