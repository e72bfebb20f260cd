#pragma once
// The steps of all wheels of a machine. Private to this folder.

#include <optional>
#include <vector>

#include <groundtruth/implementations/engine.hpp>
#include <groundtruth/rig/machine.hpp>
#include <groundtruth/rig/step_record.hpp>

namespace groundtruth::rig {

// Keeps one ask a wheel, so that no wheel's parameters are copied in a step.
class WheelSteps {
 public:
  WheelSteps(const Machine& machine, const implementations::EngineOnScene& ground, double h);

  // What the engine answers for a wheel whose frame is there; where it fails, the record says so and there is
  // nothing.
  std::optional<Stepped> step(std::size_t wheel, const Frame& frame, const WheelState& state,
                              const Controls& controls, StepRecord& record);

  // Where on the way from one place to the other the ground is entered, in parts of it; nothing if it is not,
  // or at the beginning already.
  std::optional<double> entry(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;

 private:
  const Machine& machine_;
  const implementations::EngineOnScene& ground_;
  std::vector<Ask> asks_;
};

}  // namespace groundtruth::rig
