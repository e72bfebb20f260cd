#pragma once
// The steps of all wheels of a machine. Private to this folder.

#include <optional>

#include <groundtruth/rig/motion.hpp>

namespace groundtruth::rig {

// One wheel's ask at this place of the body.
StepAsk step_ask(const MountedWheel& wheel, const BodyState& body, const WheelState& state,
                 const Controls& controls, double h);

// What an engine answered; where it failed, the record says so and there is nothing.
std::optional<Stepped> stepped(const Answer& answer, std::size_t wheel, StepRecord& record);

}  // namespace groundtruth::rig
