// Machines that stand still.

#include <groundtruth/rig/builtin_parts.hpp>

namespace groundtruth::rig {
namespace {

Scenario parked(const std::string& name, const std::string& what, double rise, const Machine& machine) {
  Scenario scenario;
  scenario.name = name;
  scenario.description = what;
  scenario.machine = machine;
  scenario.start = start_on_slope(rise);
  scenario.scene = scene_of(sloping_ground(rise));
  scenario.inputs = plain_inputs(full_brake);
  scenario.duration = 3600;
  return scenario;
}

// A steady push from the left with a vibration upon it: together less than half of what friction can hold.
Scenario crosswind() {
  Scenario scenario =
      parked("crosswind", "pushed from the side under a vibration of 5 Hz", 0, light_aircraft(soft_gear));
  scenario.inputs.push_in_world[1] = {{{0, 0}, {1, -1500}}, 1000, 5};
  scenario.duration = 60;
  return scenario;
}

// The soft gear has h omega = 0.4 at 60 steps a second. From a half kick the state soon recurs to the last
// bit, and the year need not be played; from a whole one it was not seen to in 10^8 steps.
Scenario year() {
  Scenario scenario = parked("parked-year", "three wheels on a slope of 5 % for a year of 60 steps a second",
                             0.05, light_aircraft(soft_gear));
  scenario.integrator = Integrator::half_kick;
  scenario.h = 1.0 / 60;
  scenario.duration = 365.25 * 24 * 3600;
  return scenario;
}

}  // namespace

void add_parked(std::vector<Scenario>& scenarios) {
  const Machine aircraft = light_aircraft(stiff_gear), one = one_wheel(stiff_gear);
  scenarios.push_back(parked("parked-5", "three wheels on a slope of 5 %, braked", 0.05, aircraft));
  scenarios.push_back(parked("parked-10", "three wheels on a slope of 10 %, braked", 0.1, aircraft));
  scenarios.push_back(parked("parked-one-5", "one wheel on a slope of 5 %, braked", 0.05, one));
  scenarios.push_back(parked("parked-one-10", "one wheel on a slope of 10 %, braked", 0.1, one));
  scenarios.push_back(year());
  scenarios.push_back(crosswind());
}

}  // namespace groundtruth::rig
