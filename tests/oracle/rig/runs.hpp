#pragma once
// What the tests of the rig share: a scenario that was played, moment by moment.

#include <groundtruth/rig/builtin_scenarios.hpp>
#include <groundtruth/rig/simulation.hpp>

namespace groundtruth::rig::testing {

struct Playback {
  Summary summary;
  std::vector<double> times;
  std::vector<MotionState> states;  // after each step
};

inline Playback run_of(const Scenario& scenario, const std::string& engine = "fast") {
  Playback run;
  run.summary = play(scenario, engine, Repetitions::played, [&](const Moment& moment) {
    run.times.push_back(moment.time);
    run.states.push_back(moment.state);
  });
  return run;
}

inline Scenario builtin(std::string_view name) { return *find_builtin_scenario(name); }

inline const Contact* contact_of(const WheelState& wheel) { return std::get_if<Contact>(&wheel); }

inline bool is_airborne(const MotionState& state) {
  for (const WheelState& wheel : state.wheels)
    if (contact_of(wheel)) return false;
  return true;
}

inline bool has_grip(const MotionState& state, Grip grip) {
  for (const WheelState& wheel : state.wheels)
    if (contact_of(wheel) && contact_of(wheel)->grip == grip) return true;
  return false;
}

}  // namespace groundtruth::rig::testing
