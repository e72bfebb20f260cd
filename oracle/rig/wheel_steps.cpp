#include <groundtruth/rig/wheel_steps.hpp>

#include <groundtruth/rig/body.hpp>

namespace groundtruth::rig {
namespace {

Halt halt_of(StepFailure failure) {
  switch (failure) {
    case StepFailure::wheel_broken:
      return Halt::wheel_broken;
    case StepFailure::surface_too_steep:
      return Halt::surface_too_steep;
    case StepFailure::surface_gave_way:
      return Halt::surface_gave_way;
  }
  return Halt::none;
}

}  // namespace

StepAsk step_ask(const MountedWheel& wheel, const BodyState& body, const WheelState& state,
                 const Controls& controls, double h) {
  return {wheel.wheel, frame_of(body, wheel, controls), controls.brake * wheel.brake_share, h, state};
}

std::optional<Stepped> stepped(const Answer& answer, std::size_t wheel, StepRecord& record) {
  const auto& step = std::get<StepAnswer>(answer);
  if (const auto* done = std::get_if<Stepped>(&step)) return *done;
  record.halting_wheel = wheel;
  if (const auto* failure = std::get_if<StepFailure>(&step)) {
    record.halt = halt_of(*failure);
  } else {
    record.halt = Halt::refused;
    record.reason = std::get<Refusal>(step).reason;
  }
  return std::nullopt;
}

}  // namespace groundtruth::rig
