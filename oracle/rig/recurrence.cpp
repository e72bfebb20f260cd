#include <groundtruth/rig/recurrence.hpp>

namespace groundtruth::rig {
namespace {

bool is_same(const BodyState& a, const BodyState& b) {
  return a.position_in_world == b.position_in_world &&
         a.world_from_body.coeffs() == b.world_from_body.coeffs() &&
         a.velocity_in_world == b.velocity_in_world &&
         a.angular_velocity_in_world == b.angular_velocity_in_world;
}

}  // namespace

std::optional<std::uint64_t> Recurrence::period_at(const MotionState& state) {
  if (remembered_ && is_same(remembered_->body, state.body) && remembered_->wheels == state.wheels)
    return state.steps - remembered_->steps;
  if (!remembered_ || state.steps - remembered_->steps == patience_) {
    patience_ *= 2;
    remembered_ = state;
  }
  return std::nullopt;
}

}  // namespace groundtruth::rig
