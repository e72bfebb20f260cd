#pragma once
// A machine set in motion: its wheels' steps come from any engine, its body from one of three integrators.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <groundtruth/implementations/engine.hpp>
#include <groundtruth/rig/machine.hpp>

namespace groundtruth::rig {

enum class Integrator {
  // Forces at the start of a step push the velocities, these move the body. Stable while h omega is below
  // 2 (sqrt(1 + zeta^2) - zeta).
  semi_implicit,
  // The same, but the first push is half as long: velocities stand between positions from then on, and
  // stopping
  // distances are right to second order.
  half_kick,
  // Forces are those at the end of the step, inside the border there: stable at any stiffness.
  implicit
};

// "semi-implicit", "half-kick", "implicit".
std::string_view name_of(Integrator integrator);

// Why a motion cannot go on; the state is then the one before the step.
enum class Halt { none, wheel_broken, surface_too_steep, surface_gave_way, refused, not_finite, not_solved };

std::string_view name_of(Halt halt);

// What one step did, for whoever measures.
struct StepRecord {
  Halt halt = Halt::none;
  std::size_t halting_wheel = 0;
  std::string reason;                            // of a refusal
  std::vector<Eigen::Vector3d> forces_in_world;  // on the body, one a wheel
  double border_violation = 0;                   // of friction beyond disc or band, in parts of the load
  int newton_steps = 0;                          // of the implicit integrator
  int convex_passes = 0;
};

class Motion {
 public:
  // `ground` is an engine with the scene prepared; it and the machine must outlive the motion. h > 0.
  Motion(const Machine& machine, const implementations::EngineOnScene& ground, Integrator integrator,
         double h);

  // Takes `state` one step further, or leaves it and says why not. A state's wheels are as many as the
  // machine's.
  StepRecord advance(MotionState& state, const Controls& controls) const;

  double h() const { return h_; }

 private:
  StepRecord advance_explicitly(MotionState& state, const Controls& controls, double kick) const;
  StepRecord advance_implicitly(MotionState& state, const Controls& controls) const;

  const Machine& machine_;
  const implementations::EngineOnScene& ground_;
  Integrator integrator_;
  double h_;
};

// Kinetic energy, height, and springs of the wheels in contact, J. Zero height is the world's origin.
double energy_of(const Machine& machine, const MotionState& state, const Controls& controls);

}  // namespace groundtruth::rig
