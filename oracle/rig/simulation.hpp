#pragma once
// A scenario played from its start, and what came of it.

#include <functional>
#include <optional>

#include <groundtruth/rig/scenario.hpp>

namespace groundtruth::rig {

// What an observer is shown: the state after a step, and what the step did.
struct Moment {
  double time = 0;  // s, after the step
  const MotionState& state;
  const StepRecord& record;
  const Controls& controls;
  double energy = 0;  // J
};

struct Summary {
  double duration_s = 0;  // as far as it came
  std::uint64_t steps = 0;
  double body_drift_m = 0;    // how far the body moved in the second half
  double pebble_drift_m = 0;  // of the pebble that moved most in the second half
  double energy_rise = 0;     // the largest in a step beyond the work of thrust and push, in parts of m g 1 m
  double border_violation = 0;
  std::uint64_t wheel_steps_free = 0;
  std::uint64_t wheel_steps_stick = 0;
  std::uint64_t wheel_steps_slip = 0;
  int most_newton_steps = 0;
  int most_convex_passes = 0;
  Halt outcome = Halt::none;
  std::size_t halting_wheel = 0;
  std::string reason;  // of a refusal
  // If the state came back to the last bit under constant inputs: all further rounds are known, and were not
  // played. The step at which that was seen, and the length of a round.
  std::optional<std::pair<std::uint64_t, std::uint64_t>> recurrence;
};

// Are rounds that are known to the last bit played again?
enum class Repetitions { skipped, played };

// Plays the scenario on an engine of the step ("fast", "exact", "double", "as-written:..."). The observer may
// be empty; it is not shown what is skipped.
Summary play(const Scenario& scenario, const std::string& engine,
             Repetitions repetitions = Repetitions::skipped,
             const std::function<void(const Moment&)>& observer = {});

}  // namespace groundtruth::rig
