#pragma once
// Velocities at the end of a step with which all contacts agree. Private to this folder; the method and what
// is known of its convergence: proofs-notes/rig.md.

#include <optional>
#include <vector>

#include <groundtruth/rig/contact_law.hpp>

namespace groundtruth::rig {

struct ImplicitProblem {
  const BodyState& start;
  Matrix6 mass;
  Vector6 free_velocities;  // at the end, were there no ground
  double h = 0;
  bool turns = true;  // else torques do nothing
  std::vector<ContactLaw> contacts;
};

struct ImplicitSolution {
  Vector6
      path_velocities;  // that lead to where the law gives `forces_in_world`, as well as doubles can say it
  Vector6 velocities;   // that these forces leave: the border holds for all that changes momentum
  std::vector<Eigen::Vector3d> forces_in_world;  // on the body, one a contact, within its border
  int newton_steps = 0;
  int convex_passes = 0;  // with frozen discs, where Newton's step did not help
  double mismatch = 0;    // of a force against the law at `velocities`, in parts of its load
};

// Nothing if no velocities were found: the step is to be made shorter, or given up.
std::optional<ImplicitSolution> solve(const ImplicitProblem& problem);

}  // namespace groundtruth::rig
