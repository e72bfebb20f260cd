#include <groundtruth/rig/wheel_steps.hpp>

#include <cmath>
#include <utility>

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

// The mere sum of all numbers tells: it is finite only if they are.
bool is_finite(const Frame& frame, double brake) {
  double sum = brake;
  for (const double x : frame.position_in_world) sum += std::abs(x);
  for (const double x : frame.world_from_wheel) sum += std::abs(x);
  for (const double x : frame.velocity_in_world) sum += std::abs(x);
  for (const double x : frame.angular_velocity_in_world) sum += std::abs(x);
  return std::isfinite(sum);
}

}  // namespace

WheelSteps::WheelSteps(const Machine& machine, const implementations::EngineOnScene& ground, double h)
    : machine_(machine), ground_(ground) {
  for (const MountedWheel& wheel : machine.wheels) asks_.push_back(StepAsk{wheel.wheel, {}, 0, h, Free{}});
}

std::optional<Stepped> WheelSteps::step(std::size_t wheel, const Frame& frame, const WheelState& state,
                                        const Controls& controls, StepRecord& record) {
  auto& ask = std::get<StepAsk>(asks_[wheel]);
  ask.frame = frame;
  ask.brake = controls.brake * machine_.wheels[wheel].brake_share;
  ask.state = state;
  record.halting_wheel = wheel;
  if (!is_finite(ask.frame, ask.brake)) {
    record.halt = Halt::not_finite;
    return std::nullopt;
  }
  Answer answer = ground_.answer(asks_[wheel]).answer;
  auto& step = std::get<StepAnswer>(answer);
  if (auto* done = std::get_if<Stepped>(&step)) return std::move(*done);
  if (const auto* failure = std::get_if<StepFailure>(&step)) {
    record.halt = halt_of(*failure);
  } else {
    record.halt = Halt::refused;
    record.reason = std::get<Refusal>(step).reason;
  }
  return std::nullopt;
}

std::optional<double> WheelSteps::entry(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
  if (!from.allFinite() || !to.allFinite()) return std::nullopt;
  const Ask ask = EntryAsk{{from.x(), from.y(), from.z()}, {to.x(), to.y(), to.z()}, 0, 1};
  const auto entry = std::get<EntryAnswer>(ground_.answer(ask).answer);
  const auto* border = std::get_if<Border>(&entry);
  return border != nullptr && border->lambda > 0 ? std::optional(border->lambda) : std::nullopt;
}

}  // namespace groundtruth::rig
