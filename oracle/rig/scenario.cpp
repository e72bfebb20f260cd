#include <groundtruth/rig/scenario.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace groundtruth::rig {
namespace {

Eigen::Vector3d vector_at(const std::array<Signal, 3>& signals, double time) {
  return {signals[0].at(time), signals[1].at(time), signals[2].at(time)};
}

}  // namespace

double Signal::at(double time) const {
  const double wave = amplitude == 0 ? 0 : amplitude * std::sin(2 * std::numbers::pi * frequency * time);
  if (points.empty()) return wave;
  const auto after =
      std::find_if(points.begin(), points.end(), [&](const auto& p) { return p.first > time; });
  if (after == points.begin()) return points.front().second + wave;
  if (after == points.end()) return points.back().second + wave;
  const auto& [t0, v0] = *std::prev(after);
  const auto& [t1, v1] = *after;
  return std::lerp(v0, v1, (time - t0) / (t1 - t0)) + wave;
}

Controls Inputs::at(double time) const {
  return {brake.at(time), steering.at(time), vector_at(thrust_in_body, time), vector_at(push_in_world, time),
          vector_at(gravity_in_world, time)};
}

bool Inputs::are_constant() const {
  const auto all = [](const std::array<Signal, 3>& signals) {
    return std::all_of(signals.begin(), signals.end(),
                       [](const Signal& signal) { return signal.is_constant(); });
  };
  return brake.is_constant() && steering.is_constant() && all(thrust_in_body) && all(push_in_world) &&
         all(gravity_in_world);
}

MotionState Scenario::state_at_start() const {
  MotionState state{start, start_wheels, 0};
  state.wheels.resize(machine.wheels.size(), Free{});
  return state;
}

}  // namespace groundtruth::rig
