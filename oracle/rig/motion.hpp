#pragma once
// A machine set in motion: its wheels' steps come from any engine, its body from one of three integrators.

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include <groundtruth/implementations/engine.hpp>
#include <groundtruth/rig/machine.hpp>
#include <groundtruth/rig/step_record.hpp>
#include <groundtruth/rig/wheel_steps.hpp>

namespace groundtruth::rig {

enum class Integrator {
  // Forces at the start of a step push the velocities, these move the body. Stable while h omega is below
  // 2 (sqrt(1 + zeta^2) - zeta).
  semi_implicit,
  // The same, but the first push is half as long: velocities stand between positions from then on, and
  // stopping distances are right to second order.
  half_kick,
  // Forces are those at the end of the step, inside the border there: stable at any stiffness. Where no such
  // forces are found the step is taken in 2, 4, ... 64 parts.
  implicit
};

// "semi-implicit", "half-kick", "implicit".
std::string_view name_of(Integrator integrator);
std::optional<Integrator> integrator_named(std::string_view name);

class Motion {
 public:
  // `ground` is an engine with the scene prepared; it and the machine must outlive the motion. h > 0.
  Motion(const Machine& machine, const implementations::EngineOnScene& ground, Integrator integrator,
         double h);

  // Takes `state` one step further, or leaves it and says why not. A state's wheels are as many as the
  // machine's. The record is the motion's own: the next step overwrites it.
  const StepRecord& advance(MotionState& state, const Controls& controls);

  double h() const { return h_; }

 private:
  void advance_explicitly(MotionState& state, const Controls& controls, double kick);
  void advance_implicitly(MotionState& state, const Controls& controls);

  const Machine& machine_;
  const implementations::EngineOnScene& ground_;
  Integrator integrator_;
  double h_;
  WheelSteps wheel_steps_;
  StepRecord record_;
  std::vector<WheelState> next_wheels_;
};

}  // namespace groundtruth::rig
