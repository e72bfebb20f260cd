#include <groundtruth/rig/motion.hpp>

#include <algorithm>

#include <groundtruth/rig/body.hpp>
#include <groundtruth/rig/contact_law.hpp>

namespace groundtruth::rig {
namespace {

constexpr std::array<std::string_view, 3> integrator_names{"semi-implicit", "half-kick", "implicit"};

// A frame that left the range of doubles must not be asked about.
bool is_finite(const BodyState& body) {
  return body.position_in_world.allFinite() && body.velocity_in_world.allFinite() &&
         body.angular_velocity_in_world.allFinite() && body.world_from_body.coeffs().allFinite();
}

}  // namespace

std::string_view name_of(Integrator integrator) {
  return integrator_names[static_cast<std::size_t>(integrator)];
}

std::optional<Integrator> integrator_named(std::string_view name) {
  const auto found = std::find(integrator_names.begin(), integrator_names.end(), name);
  if (found == integrator_names.end()) return std::nullopt;
  return static_cast<Integrator>(found - integrator_names.begin());
}

std::string_view name_of(Halt halt) {
  constexpr std::array<std::string_view, 7> names{
      "none", "wheel_broken", "surface_too_steep", "surface_gave_way", "refused", "not_finite", "not_solved"};
  return names[static_cast<std::size_t>(halt)];
}

Motion::Motion(const Machine& machine, const implementations::EngineOnScene& ground, Integrator integrator,
               double h)
    : machine_(machine), ground_(ground), integrator_(integrator), h_(h), wheel_steps_(machine, ground, h) {}

const StepRecord& Motion::advance(MotionState& state, const Controls& controls) {
  record_.halt = Halt::none;
  record_.newton_steps = record_.convex_passes = 0;
  record_.parts = 1;
  record_.forces_in_world.clear();
  record_.border_violation = 0;
  if (integrator_ == Integrator::implicit) {
    advance_implicitly(state, controls);
  } else {
    const bool is_first_half = integrator_ == Integrator::half_kick && state.steps == 0;
    advance_explicitly(state, controls, is_first_half ? h_ / 2 : h_);
  }
  return record_;
}

void Motion::advance_explicitly(MotionState& state, const Controls& controls, double kick) {
  const Eigen::Matrix3d world_from_body = rotation_of(state.body.world_from_body);
  Vector6 wrench = wrench_without_ground(machine_, state.body, world_from_body, controls);
  next_wheels_.clear();
  for (std::size_t i = 0; i < machine_.wheels.size(); ++i) {
    const MountedWheel& wheel = machine_.wheels[i];
    const Frame frame = frame_of(state.body, world_from_body, wheel, controls);
    const auto done = wheel_steps_.step(i, frame, state.wheels[i], controls, record_);
    if (!done) return;
    next_wheels_.push_back(done->state);
    const Eigen::Vector3d force = vector_of(done->force_on_frame_in_world);
    record_.forces_in_world.push_back(force);
    const auto* contact = std::get_if<Contact>(&state.wheels[i]);
    if (contact == nullptr) continue;
    wrench.head<3>() += force;
    const Eigen::Vector3d arm = vector_of(contact->pebble_in_world) - state.body.position_in_world;
    if (machine_.turns()) wrench.tail<3>() += arm.cross(force);
    const Eigen::Matrix3d wheel_from_world = world_from_wheel(frame).transpose();
    const double violation =
        border_violation(wheel_from_world * force, wheel_from_world * vector_of(contact->normal_in_world),
                         border_of(*contact, wheel, controls));
    record_.border_violation = std::max(record_.border_violation, violation);
  }
  const Vector6 velocities =
      velocities_of(state.body) + kick * accelerations(machine_, world_from_body, wrench);
  const BodyState moved = drifted(state.body, velocities, h_);
  if (!is_finite(moved)) {
    record_.halt = Halt::not_finite;
    return;
  }
  state.body = moved;
  state.wheels.swap(next_wheels_);
  ++state.steps;
}

}  // namespace groundtruth::rig
