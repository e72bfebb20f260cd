#include <groundtruth/rig/motion.hpp>

#include <algorithm>

#include <groundtruth/rig/contact_law.hpp>
#include <groundtruth/rig/wheel_steps.hpp>

namespace groundtruth::rig {
namespace {

Eigen::Vector3d vector_of(const Vector& v) { return {v[0], v[1], v[2]}; }

// A frame that left the range of doubles must not be asked about.
bool is_finite(const BodyState& body) {
  return body.position_in_world.allFinite() && body.velocity_in_world.allFinite() &&
         body.angular_velocity_in_world.allFinite() && body.world_from_body.coeffs().allFinite();
}

// Where a wheel's force acts: at its pebble, or at its frame's origin if it touches nothing.
Eigen::Vector3d place_of_force(const WheelState& state, const Frame& frame) {
  if (const auto* contact = std::get_if<Contact>(&state)) return vector_of(contact->pebble_in_world);
  return vector_of(frame.position_in_world);
}

}  // namespace

std::string_view name_of(Integrator integrator) {
  constexpr std::array<std::string_view, 3> names{"semi-implicit", "half-kick", "implicit"};
  return names[static_cast<std::size_t>(integrator)];
}

std::string_view name_of(Halt halt) {
  constexpr std::array<std::string_view, 7> names{
      "none", "wheel_broken", "surface_too_steep", "surface_gave_way", "refused", "not_finite", "not_solved"};
  return names[static_cast<std::size_t>(halt)];
}

Motion::Motion(const Machine& machine, const implementations::EngineOnScene& ground, Integrator integrator,
               double h)
    : machine_(machine), ground_(ground), integrator_(integrator), h_(h) {}

StepRecord Motion::advance(MotionState& state, const Controls& controls) const {
  if (integrator_ == Integrator::implicit) return advance_implicitly(state, controls);
  const bool is_first_half = integrator_ == Integrator::half_kick && state.steps == 0;
  return advance_explicitly(state, controls, is_first_half ? h_ / 2 : h_);
}

StepRecord Motion::advance_explicitly(MotionState& state, const Controls& controls, double kick) const {
  StepRecord record;
  std::vector<WheelState> wheels;
  Vector6 wrench = wrench_without_ground(machine_, state.body, controls);
  for (std::size_t i = 0; i < machine_.wheels.size(); ++i) {
    const StepAsk ask = step_ask(machine_.wheels[i], state.body, state.wheels[i], controls, h_);
    const auto done = stepped(ground_.answer(ask).answer, i, record);
    if (!done) return record;
    wheels.push_back(done->state);
    const Eigen::Vector3d force = vector_of(done->force_on_frame_in_world);
    const Eigen::Vector3d arm = place_of_force(state.wheels[i], ask.frame) - state.body.position_in_world;
    wrench.head<3>() += force;
    if (machine_.turns()) wrench.tail<3>() += arm.cross(force);
    record.forces_in_world.push_back(force);
    if (const auto* contact = std::get_if<Contact>(&state.wheels[i])) {
      const AskedForce asked = ContactLaw(machine_.wheels[i], *contact, controls, h_).at(state.body);
      record.border_violation = std::max(record.border_violation, border_violation(force, asked));
    }
  }
  const Vector6 velocities =
      velocities_of(state.body) + kick * mass_matrix(machine_, state.body).llt().solve(wrench);
  const BodyState moved = drifted(state.body, velocities, h_);
  if (!is_finite(moved)) {
    record.halt = Halt::not_finite;
    return record;
  }
  state = {moved, std::move(wheels), state.steps + 1};
  return record;
}

double energy_of(const Machine& machine, const MotionState& state, const Controls& controls) {
  const Vector6 velocities = velocities_of(state.body);
  double energy = velocities.dot(mass_matrix(machine, state.body) * velocities) / 2 -
                  machine.mass * controls.gravity_in_world.dot(state.body.position_in_world);
  for (std::size_t i = 0; i < machine.wheels.size(); ++i) {
    const auto* contact = std::get_if<Contact>(&state.wheels[i]);
    if (contact == nullptr) continue;
    const Wheel& wheel = machine.wheels[i].wheel;
    const Frame frame = frame_of(state.body, machine.wheels[i], controls);
    const auto& q = frame.world_from_wheel;
    const Eigen::Vector3d p = rotation_of(Eigen::Quaterniond(q[0], q[1], q[2], q[3])).transpose() *
                              (vector_of(contact->pebble_in_world) - vector_of(frame.position_in_world));
    if (p.z() >= wheel.z_max) continue;
    const double compression = p.z() - wheel.z_zero;
    energy -= wheel.k_xy * p.head<2>().squaredNorm() / 2 + wheel.k_z * compression * compression / 2;
  }
  return energy;
}

}  // namespace groundtruth::rig
