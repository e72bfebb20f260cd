// Slopes on which friction does not hold, or holds no longer.

#include <groundtruth/rig/builtin_parts.hpp>

namespace groundtruth::rig {
namespace {

// Heads down: with the nose up the slope it would tip over backwards.
Scenario slide() {
  constexpr double rise = -0.6;
  Scenario scenario;
  scenario.name = "slide";
  scenario.description = "three braked wheels on a slope of 60 %, above the angle of friction";
  scenario.machine = light_aircraft(stiff_gear);
  scenario.start = start_on_slope(rise);
  scenario.scene = scene_of(sloping_ground(rise));
  scenario.inputs = plain_inputs(full_brake);
  scenario.duration = 4;
  return scenario;
}

// Gravity leans back by 1 % of its vertical part a second: the friction at rest, 0.5, is used up at 50 s.
Scenario tilt() {
  constexpr double end = 55;
  Scenario scenario;
  scenario.name = "tilt";
  scenario.description = "one braked wheel, tilted slowly until it slips";
  scenario.machine = one_wheel(stiff_gear);
  scenario.start = start_on_slope(0);
  scenario.scene = scene_of(sloping_ground(0));
  scenario.inputs = plain_inputs(full_brake);
  scenario.inputs.gravity_in_world[0].points = {{0, 0}, {end, -0.01 * end * gravity}};
  scenario.duration = end;
  return scenario;
}

}  // namespace

void add_sliding(std::vector<Scenario>& scenarios) {
  scenarios.push_back(slide());
  scenarios.push_back(tilt());
}

}  // namespace groundtruth::rig
