#pragma once
// The scenarios built into the program: a light aircraft of 1,200 kg on three wheels, or a body that does not
// turn on one ("one" in the name), on ground whose dry part has friction 0.5 at rest and 0.4 sliding.

#include <string_view>
#include <vector>

#include <groundtruth/rig/scenario.hpp>

namespace groundtruth::rig {

// In the order in which reports show them.
const std::vector<Scenario>& builtin_scenarios();

// Null if there is none of this name.
const Scenario* find_builtin_scenario(std::string_view name);

}  // namespace groundtruth::rig
