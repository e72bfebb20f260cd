#include <groundtruth/rig/simulation.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <groundtruth/rig/body.hpp>
#include <groundtruth/rig/energy.hpp>
#include <groundtruth/rig/recurrence.hpp>

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

// Of thrust and push, over a step.
double work_of(const Controls& controls, const BodyState& before, const BodyState& after) {
  const Eigen::Vector3d moved = after.position_in_world - before.position_in_world;
  const double work = controls.push_in_world.dot(moved);
  if (controls.thrust_in_body.isZero(0)) return work;
  return work + (rotation_of(before.world_from_body) * controls.thrust_in_body).dot(moved);
}

class Player {
 public:
  Player(const Scenario& scenario, const implementations::EngineOnScene& ground,
         const std::function<void(const Moment&)>& observer)
      : scenario_(scenario),
        ground_(ground),
        motion_(scenario.machine, ground, scenario.integrator, scenario.h),
        observer_(observer),
        are_inputs_constant_(scenario.inputs.are_constant()),
        controls_(scenario.inputs.at(0)),
        steps_(static_cast<std::uint64_t>(std::llround(scenario.duration / scenario.h))),
        state_(scenario.state_at_start()),
        middle_(state_),
        energy_(energy_of(scenario.machine, ground, state_, controls_)) {}

  Summary run(Repetitions repetitions) {
    Recurrence recurrence;
    const bool may_skip = repetitions == Repetitions::skipped && are_inputs_constant_;
    while (summary_.steps < steps_ && take_step()) {
      if (!may_skip || summary_.recurrence) continue;
      if (const auto period = recurrence.period_at(state_)) skip_rounds_of(*period);
    }
    summary_.duration_s = static_cast<double>(summary_.steps) * scenario_.h;
    measure_drift(middle_, state_, summary_);
    return summary_;
  }

 private:
  bool take_step() {
    const double time = static_cast<double>(summary_.steps) * scenario_.h;
    if (!are_inputs_constant_) controls_ = scenario_.inputs.at(time);
    const BodyState before = state_.body;
    const StepRecord& record = motion_.advance(state_, controls_);
    if (record.halt != Halt::none) {
      summary_.outcome = record.halt;
      summary_.halting_wheel = record.halting_wheel;
      summary_.reason = record.reason;
      return false;
    }
    ++summary_.steps;
    add(record, summary_);
    count(state_, summary_);
    measure_energy(before);
    if (summary_.steps == steps_ / 2) middle_ = state_;
    if (observer_) observer_({time + scenario_.h, state_, record, controls_, energy_});
    return true;
  }

  void measure_energy(const BodyState& before) {
    const double energy = energy_of(scenario_.machine, ground_, state_, controls_);
    const double weight = scenario_.machine.mass * controls_.gravity_in_world.norm();
    const double work = work_of(controls_, before, state_.body);
    if (weight > 0) summary_.energy_rise = std::max(summary_.energy_rise, (energy - energy_ - work) / weight);
    energy_ = energy;
  }

  // One more round is played to count it; then as many as still fit are taken as played.
  void skip_rounds_of(std::uint64_t period) {
    summary_.recurrence = {summary_.steps, period};
    const Summary before = summary_;
    if (steps_ - summary_.steps < 2 * period) return;
    for (std::uint64_t i = 0; i < period; ++i) take_step();
    const std::uint64_t rounds = (steps_ - summary_.steps) / period;
    if (summary_.steps < steps_ / 2) middle_ = state_;
    summary_.wheel_steps_free += rounds * (summary_.wheel_steps_free - before.wheel_steps_free);
    summary_.wheel_steps_stick += rounds * (summary_.wheel_steps_stick - before.wheel_steps_stick);
    summary_.wheel_steps_slip += rounds * (summary_.wheel_steps_slip - before.wheel_steps_slip);
    summary_.steps += rounds * period;
  }

  const Scenario& scenario_;
  const implementations::EngineOnScene& ground_;
  Motion motion_;
  const std::function<void(const Moment&)>& observer_;
  const bool are_inputs_constant_;
  Controls controls_;
  const std::uint64_t steps_;
  MotionState state_;
  MotionState middle_;
  double energy_;
  Summary summary_;
};

}  // namespace

Summary play(const Scenario& scenario, const std::string& engine, Repetitions repetitions,
             const std::function<void(const Moment&)>& observer) {
  const auto ground = implementations::make_engine(engine)->on(scenario.scene);
  return Player(scenario, *ground, observer).run(repetitions);
}

}  // namespace groundtruth::rig
