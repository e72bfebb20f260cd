// Off the ground's end, and beyond the wheel's.

#include <memory>

#include <groundtruth/rig/builtin_parts.hpp>

namespace groundtruth::rig {
namespace {

// The ground ends at x = 10.
Scenario edge() {
  Scenario scenario;
  scenario.name = "edge";
  scenario.description = "rolls off the runway's end at 10 m/s";
  scenario.machine = light_aircraft(soft_gear);
  scenario.start = start_on_slope(0, 10);
  const auto runway = Intersection{{Shape{HalfSpace{{0, 0, 1}, 0}}, Shape{HalfSpace{{1, 0, 0}, 10}}}};
  scenario.scene = scene_of({Covered{dry, std::make_shared<Shape>(Shape{runway})}});
  scenario.inputs = plain_inputs(0);
  scenario.duration = 2;
  return scenario;
}

// A load on the centre of mass that grows by 60 kN a second.
Scenario overload() {
  Scenario scenario;
  scenario.name = "overload";
  scenario.description = "pressed down harder and harder, until a wheel breaks";
  scenario.machine = light_aircraft(soft_gear);
  scenario.start = start_on_slope(0);
  scenario.scene = scene_of(sloping_ground(0));
  scenario.inputs = plain_inputs(full_brake);
  scenario.inputs.push_in_world[2].points = {{0, 0}, {10, -600000}};
  scenario.duration = 10;
  return scenario;
}

}  // namespace

void add_extremes(std::vector<Scenario>& scenarios) {
  scenarios.push_back(edge());
  scenarios.push_back(overload());
}

}  // namespace groundtruth::rig
