// Braking from 30 m/s.

#include <groundtruth/rig/builtin_parts.hpp>

namespace groundtruth::rig {
namespace {

constexpr double speed = 30;  // m/s

Scenario stop(const std::string& name, const std::string& what, Shape ground, double duration) {
  Scenario scenario;
  scenario.name = name;
  scenario.description = what;
  scenario.machine = light_aircraft(stiff_gear);
  scenario.start = start_on_slope(0, speed);
  scenario.scene = scene_of(std::move(ground));
  scenario.inputs = plain_inputs(full_brake);
  scenario.integrator = Integrator::half_kick;
  scenario.duration = duration;
  return scenario;
}

// Starts at rest in the vertical, its pebble 0.1 m behind and slipping: from the first step on the
// deceleration is mu g, and the path is v^2 / (2 mu g) but for the error of the integrator.
Scenario stop_of_one_wheel() {
  Scenario scenario = stop("stop-one", "one settled wheel stops on dry ground", sloping_ground(0), 10);
  scenario.machine = one_wheel(stiff_gear);
  const double sag = gravity / (stiff_gear * stiff_gear);
  scenario.start.position_in_world.z() -= sag;
  scenario.start_wheels = {Contact{Grip::slip, {-0.1, 0, 0}, {}, {0, 0, 1}, 0.5, 0.4, 1e7}};
  return scenario;
}

// Turns to the right, where the ground holds.
Scenario one_on_ice() {
  return stop("one-on-ice", "a stop with the left main wheel on ice",
              painted(icy, {{0, -1, 0}, -1}, sloping_ground(0)), 3);
}

}  // namespace

void add_stops(std::vector<Scenario>& scenarios) {
  scenarios.push_back(stop("stop-dry", "a stop from 30 m/s on dry ground", sloping_ground(0), 10));
  scenarios.push_back(stop("stop-wet", "a stop from 30 m/s on wet ground", sloping_ground(0, wet), 40));
  scenarios.push_back(stop("stop-paint", "from 30 m/s on dry ground, then on the ice painted from 50 m on",
                           painted(icy, {{-1, 0, 0}, -50}, sloping_ground(0)), 10));
  scenarios.push_back(stop_of_one_wheel());
  scenarios.push_back(one_on_ice());
}

}  // namespace groundtruth::rig
