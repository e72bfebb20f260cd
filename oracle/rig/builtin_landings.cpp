// Touching down.

#include <memory>

#include <groundtruth/rig/builtin_parts.hpp>

namespace groundtruth::rig {
namespace {

Scenario landing(const std::string& name, const std::string& what, double sink, Shape ground) {
  Scenario scenario;
  scenario.name = name;
  scenario.description = what;
  scenario.machine = light_aircraft(soft_gear);
  scenario.start = start_above_ground(0.25, 30, sink);
  scenario.scene = scene_of(std::move(ground));
  scenario.inputs = plain_inputs(0);
  scenario.duration = 4;
  return scenario;
}

// A ramp of 10 % joins level ground at x = 0. Speeds, steps and places are short binary fractions: at the
// first step with the struts on the ground, the main wheels stand at x = 0 to the last bit.
Scenario seam() {
  constexpr int steps = 32;
  constexpr double step = 1.0 / 256, speed = 30, sink = 2;
  Scenario scenario =
      landing("seam", "a landing whose main wheels touch down on the seam of a ramp", sink, {});
  scenario.h = step;
  const auto ground = Union{{Shape{HalfSpace{{0, 0, 1}, 0}}, Shape{HalfSpace{{-0.1, 0, 1}, 0}}}};
  scenario.scene.shape = {Covered{dry, std::make_shared<Shape>(Shape{ground})}};
  // The fall of half a step less than `steps` steps.
  const double fall = (steps - 0.5) * step * sink + gravity * step * step * steps * (steps + 1) / 2;
  scenario.start = start_above_ground(fall, speed, sink);
  scenario.start.position_in_world.x() = -steps * step * speed - scenario.machine.wheels[1].place_in_body.x();
  return scenario;
}

}  // namespace

void add_landings(std::vector<Scenario>& scenarios) {
  for (int sink = 1; sink <= 6; ++sink) {
    const std::string number = std::to_string(sink);
    scenarios.push_back(landing("land-" + number,
                                "a landing on three wheels with a sink of " + number + " m/s", sink,
                                sloping_ground(0)));
  }
  scenarios.push_back(seam());
  scenarios.push_back(landing("soft", "a landing on ground that gives way", 3, sloping_ground(0, soft)));
}

}  // namespace groundtruth::rig
