#pragma once
// What a step of a motion came to.

#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace groundtruth::rig {

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
  int newton_steps = 0;                          // of the implicit integrator, in its hardest part
  int convex_passes = 0;
  int parts = 1;  // in which an implicit step was taken; the forces are those of the last
};

}  // namespace groundtruth::rig
