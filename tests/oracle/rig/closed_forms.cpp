#include <groundtruth/tests/oracle/rig/closed_forms.hpp>

#include <cmath>
#include <limits>

#include <groundtruth/rig/builtin_scenarios.hpp>
#include <groundtruth/rig/simulation.hpp>

namespace groundtruth::rig {
namespace {

constexpr double gravity = 9.81, mu_dynamic = 0.4;
constexpr double speed = 30, deceleration = mu_dynamic * gravity;

// Of the speed along the slope, between these two moments.
double mean_acceleration(const Scenario& scenario, double slope, double from, double to) {
  const Eigen::Vector3d downhill = Eigen::Vector3d(-1, 0, -slope).normalized() * std::copysign(1.0, slope);
  const auto first = std::llround(from / scenario.h), last = std::llround(to / scenario.h);
  double speed_at_first = 0, speed_at_last = 0;
  long long step = 0;
  play(scenario, "fast", Repetitions::played, [&](const Moment& moment) {
    ++step;
    const double along = moment.state.body.velocity_in_world.dot(downhill);
    if (step == first) speed_at_first = along;
    if (step == last) speed_at_last = along;
  });
  return (speed_at_last - speed_at_first) / (static_cast<double>(last - first) * scenario.h);
}

Scenario slide_on_three(Body body, Integrator integrator, double h) {
  Scenario scenario = *find_builtin_scenario("slide");
  scenario.integrator = integrator;
  scenario.h = h;
  if (body == Body::three_wheels_that_cannot_turn)
    scenario.machine.inertia.setConstant(std::numeric_limits<double>::infinity());
  return scenario;
}

}  // namespace

Scenario one_wheel_on_slope(double slope, Integrator integrator, double h) {
  stability::Parked parked;
  parked.slope = slope;
  parked.integrator = integrator;
  parked.relocation = Relocation::return_mapping;
  parked.h_omega = h * 20;
  return stability::scenario_of(parked, 1);
}

double slide_error(Body body, Integrator integrator, double h) {
  const bool is_on_one = body == Body::one_wheel;
  const double slope = is_on_one ? 0.7 : -0.6, end = is_on_one ? 4000.0 / 240 : 4;
  Scenario scenario =
      is_on_one ? one_wheel_on_slope(slope, integrator, h) : slide_on_three(body, integrator, h);
  scenario.duration = end;
  const double expected = gravity / std::hypot(1, slope) * (std::abs(slope) - mu_dynamic);
  return mean_acceleration(scenario, slope, is_on_one ? 3000.0 / 240 : 3, end) / expected - 1;
}

double stop_step(int halvings) { return speed / deceleration / ((1000 + 1.0 / 3) * (1 << halvings)); }

double stop_error(Integrator integrator, int halvings) {
  Scenario scenario = *find_builtin_scenario("stop-one");
  scenario.integrator = integrator;
  scenario.h = stop_step(halvings);
  const double heave = 0.4 / scenario.h, stiffness = -1200 * heave * heave;
  Wheel& wheel = scenario.machine.wheels[0].wheel;
  wheel.k_xy = wheel.k_z = stiffness;
  wheel.d_xy = 0;
  wheel.d_z = -0.6 * 1200 * heave;
  scenario.start.position_in_world.z() = 1.1 - gravity / (heave * heave);
  scenario.duration = 8;
  double furthest = 0;
  bool moves_on = true;  // later it swings on its spring
  play(scenario, "fast", Repetitions::played, [&](const Moment& moment) {
    moves_on = moves_on && moment.state.body.velocity_in_world.x() > 0;
    if (moves_on) furthest = moment.state.body.position_in_world.x();
  });
  return furthest - speed * speed / (2 * deceleration);
}

}  // namespace groundtruth::rig
