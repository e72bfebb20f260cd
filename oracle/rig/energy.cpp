#include <groundtruth/rig/energy.hpp>

#include <groundtruth/rig/body.hpp>

namespace groundtruth::rig {
namespace {

double strut_energy(const Wheel& wheel, double z) {
  if (z >= wheel.z_max) return 0;
  const double compression = z - wheel.z_zero;
  return -wheel.k_z * compression * compression / 2;
}

// How far down its own z a free wheel meets the ground. A wheel that is broken stands at its stop.
double reach_of(const Wheel& wheel, const Eigen::Vector3d& place, const Eigen::Vector3d& down,
                const implementations::EngineOnScene& ground) {
  const Eigen::Vector3d from = place + wheel.z_min * down, to = place + wheel.z_max * down;
  const Ask ask = EntryAsk{{from.x(), from.y(), from.z()}, {to.x(), to.y(), to.z()}, 0, 1};
  const auto entry = std::get<EntryAnswer>(ground.answer(ask).answer);
  if (std::holds_alternative<Miss>(entry)) return wheel.z_max;
  const auto* border = std::get_if<Border>(&entry);
  return border == nullptr ? wheel.z_min : wheel.z_min + border->lambda * (wheel.z_max - wheel.z_min);
}

// A wheel's steering turns it about its own z, which its springs do not see.
double wheel_energy(const MountedWheel& mounted, const BodyState& body,
                    const Eigen::Matrix3d& world_from_body, const implementations::EngineOnScene& ground,
                    const WheelState& state) {
  const Wheel& wheel = mounted.wheel;
  const auto* contact = std::get_if<Contact>(&state);
  if (contact == nullptr) {
    const Eigen::Vector3d place = body.position_in_world + world_from_body * mounted.place_in_body;
    return strut_energy(wheel, reach_of(wheel, place, world_from_body.col(2), ground));
  }
  const Eigen::Vector3d arm = vector_of(contact->pebble_in_world) - body.position_in_world;
  const Eigen::Vector3d p = world_from_body.transpose() * arm - mounted.place_in_body;
  if (p.z() >= wheel.z_max) return 0;
  return strut_energy(wheel, p.z()) - wheel.k_xy * p.head<2>().squaredNorm() / 2;
}

}  // namespace

double energy_of(const Machine& machine, const implementations::EngineOnScene& ground,
                 const MotionState& state, const Controls& controls) {
  const Eigen::Matrix3d world_from_body = rotation_of(state.body.world_from_body);
  double energy = kinetic_energy(machine, state.body, world_from_body) -
                  machine.mass * controls.gravity_in_world.dot(state.body.position_in_world);
  for (std::size_t i = 0; i < machine.wheels.size(); ++i)
    energy += wheel_energy(machine.wheels[i], state.body, world_from_body, ground, state.wheels[i]);
  return energy;
}

}  // namespace groundtruth::rig
