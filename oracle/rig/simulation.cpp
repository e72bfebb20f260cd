#include <groundtruth/rig/simulation.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace groundtruth::rig {
namespace {

double distance(const Vector& a, const Vector& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// How far the pebble went; endless if one of the wheels has none.
double pebble_drift(const WheelState& from, const WheelState& to) {
  const auto* a = std::get_if<Contact>(&from);
  const auto* b = std::get_if<Contact>(&to);
  if (a == nullptr && b == nullptr) return 0;
  if (a == nullptr || b == nullptr) return std::numeric_limits<double>::infinity();
  return distance(a->pebble_in_world, b->pebble_in_world);
}

void count(const MotionState& state, Summary& summary) {
  for (const WheelState& wheel : state.wheels) {
    const auto* contact = std::get_if<Contact>(&wheel);
    if (contact == nullptr)
      ++summary.wheel_steps_free;
    else
      ++(contact->grip == Grip::stick ? summary.wheel_steps_stick : summary.wheel_steps_slip);
  }
}

void add(const StepRecord& record, Summary& summary) {
  summary.border_violation = std::max(summary.border_violation, record.border_violation);
  summary.most_newton_steps = std::max(summary.most_newton_steps, record.newton_steps);
  summary.most_convex_passes = std::max(summary.most_convex_passes, record.convex_passes);
}

void measure_drift(const MotionState& middle, const MotionState& end, Summary& summary) {
  summary.body_drift_m = (end.body.position_in_world - middle.body.position_in_world).norm();
  for (std::size_t i = 0; i < end.wheels.size(); ++i)
    summary.pebble_drift_m = std::max(summary.pebble_drift_m, pebble_drift(middle.wheels[i], end.wheels[i]));
}

}  // namespace

Summary play(const Scenario& scenario, const std::string& engine,
             const std::function<void(const Moment&)>& observer) {
  const auto ground = implementations::make_engine(engine)->on(scenario.scene);
  const Motion motion(scenario.machine, *ground, scenario.integrator, scenario.h);
  MotionState state{scenario.start, std::vector<WheelState>(scenario.machine.wheels.size(), Free{}), 0};
  MotionState middle = state;
  Summary summary;
  const auto steps = static_cast<std::uint64_t>(std::llround(scenario.duration / scenario.h));
  double energy = energy_of(scenario.machine, state, scenario.inputs.at(0));
  while (summary.steps < steps) {
    const double time = static_cast<double>(summary.steps) * scenario.h;
    const Controls controls = scenario.inputs.at(time);
    const StepRecord record = motion.advance(state, controls);
    if (record.halt != Halt::none) {
      summary.outcome = record.halt;
      summary.reason = record.reason;
      break;
    }
    ++summary.steps;
    add(record, summary);
    count(state, summary);
    const double now = energy_of(scenario.machine, state, controls);
    const double weight = scenario.machine.mass * controls.gravity_in_world.norm();
    if (weight > 0) summary.energy_rise = std::max(summary.energy_rise, (now - energy) / weight);
    energy = now;
    if (summary.steps == steps / 2) middle = state;
    if (observer) observer({time + scenario.h, state, record, controls, energy});
  }
  summary.duration_s = static_cast<double>(summary.steps) * scenario.h;
  measure_drift(middle, state, summary);
  return summary;
}

}  // namespace groundtruth::rig
