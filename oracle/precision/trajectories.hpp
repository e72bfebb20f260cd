#pragma once
// Error at the end of a motion against the time it took to compute, over ever shorter steps.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <groundtruth/rig/scenario.hpp>

namespace groundtruth::precision {

enum class RunMark {
  none,
  creeping,  // pebbles that should stand moved in the second half
  blown_up,  // a step made more than 0.1 m g 1 m of energy, and the end is more than 0.1 m off
  halted     // a step gave a reason
};

std::string_view name_of(RunMark mark);

struct TrajectoryRun {
  std::string motion;    // "smooth sliding", "full stop", "landing with bounce", "parked drift"
  double stiffness = 1;  // factor on the scenario's springs; dampers keep their ratio
  rig::Integrator integrator{};
  Relocation relocation{};
  double h = 0;        // s
  double error_m = 0;  // of the body's place at the end
  double seconds = 0;  // of this thread
  RunMark mark = RunMark::none;
  std::string reason;  // of a halt
};

// What the error is measured against, a line a motion.
struct MotionKind {
  std::string name;
  std::string description;
  std::string reference;
};
std::vector<MotionKind> motion_kinds();

struct TrajectoryPlan {
  std::vector<double> stiffnesses{1};
  int halvings = 5;  // of the longest step
};

std::vector<TrajectoryRun> run_trajectories(
    const TrajectoryPlan& plan, const std::function<void(std::uint64_t done, std::uint64_t all)>& progress);

}  // namespace groundtruth::precision
