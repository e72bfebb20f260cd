#include <groundtruth/rig/body.hpp>

#include <cmath>

namespace groundtruth::rig {
namespace {

Vector to_array(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

// Multiplied out, so that a component that is 0 by symmetry stays 0.
Eigen::Quaterniond product(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  const Eigen::Vector3d vector = a.w() * b.vec() + b.w() * a.vec() + a.vec().cross(b.vec());
  return {a.w() * b.w() - a.vec().dot(b.vec()), vector.x(), vector.y(), vector.z()};
}

Eigen::Quaterniond of_length_near_one(const Eigen::Quaterniond& q) {
  const int exponent = std::ilogb(q.coeffs().cwiseAbs().maxCoeff());
  if (exponent >= -1 && exponent <= 0) return q;
  return Eigen::Quaterniond(q.coeffs() * std::ldexp(1.0, -exponent));
}

}  // namespace

Eigen::Matrix3d rotation_of(const Eigen::Quaterniond& q) {
  const Eigen::Vector3d v = q.vec();
  const double w = q.w(), part = 1 / (w * w + v.squaredNorm());
  Eigen::Matrix3d matrix;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d e = Eigen::Vector3d::Unit(axis);
    matrix.col(axis) = part * ((w * w - v.squaredNorm()) * e + 2 * v[axis] * v + 2 * w * v.cross(e));
  }
  return matrix;
}

Vector6 velocities_of(const BodyState& body) {
  Vector6 velocities;
  velocities << body.velocity_in_world, body.angular_velocity_in_world;
  return velocities;
}

Matrix6 mass_matrix(const Machine& machine, const Eigen::Matrix3d& world_from_body) {
  Matrix6 matrix = Matrix6::Zero();
  matrix.topLeftCorner<3, 3>().diagonal().setConstant(machine.mass);
  if (machine.turns())
    matrix.bottomRightCorner<3, 3>() =
        world_from_body * machine.inertia.asDiagonal() * world_from_body.transpose();
  else
    matrix.bottomRightCorner<3, 3>().setIdentity();
  return matrix;
}

Vector6 accelerations(const Machine& machine, const Eigen::Matrix3d& world_from_body, const Vector6& wrench) {
  const Eigen::Vector3d torque_in_body = world_from_body.transpose() * wrench.tail<3>();
  Vector6 result;
  result << wrench.head<3>() / machine.mass, world_from_body * torque_in_body.cwiseQuotient(machine.inertia);
  return result;
}

double kinetic_energy(const Machine& machine, const BodyState& body, const Eigen::Matrix3d& world_from_body) {
  const double moving = machine.mass * body.velocity_in_world.squaredNorm();
  if (!machine.turns()) return moving / 2;
  const Eigen::Vector3d omega_in_body = world_from_body.transpose() * body.angular_velocity_in_world;
  return (moving + machine.inertia.dot(omega_in_body.cwiseAbs2())) / 2;
}

Vector6 wrench_without_ground(const Machine& machine, const BodyState& body,
                              const Eigen::Matrix3d& world_from_body, const Controls& controls) {
  Eigen::Vector3d turning = Eigen::Vector3d::Zero();
  if (machine.turns()) {
    const Eigen::Vector3d& omega = body.angular_velocity_in_world;
    const Eigen::Vector3d spin_in_body = machine.inertia.asDiagonal() * (world_from_body.transpose() * omega);
    turning = -omega.cross(world_from_body * spin_in_body);
  }
  Vector6 wrench;
  wrench << machine.mass * controls.gravity_in_world + world_from_body * controls.thrust_in_body +
                controls.push_in_world,
      turning;
  return wrench;
}

BodyState drifted(const BodyState& body, const Vector6& velocities, double h) {
  BodyState moved;
  moved.velocity_in_world = velocities.head<3>();
  moved.angular_velocity_in_world = velocities.tail<3>();
  moved.position_in_world = body.position_in_world + h * moved.velocity_in_world;
  const Eigen::Vector3d half_turn = h / 2 * moved.angular_velocity_in_world;
  const Eigen::Quaterniond turn(1, half_turn.x(), half_turn.y(), half_turn.z());
  moved.world_from_body = of_length_near_one(product(turn, body.world_from_body));
  return moved;
}

Frame frame_of(const BodyState& body, const Eigen::Matrix3d& world_from_body, const MountedWheel& wheel,
               const Controls& controls) {
  const Eigen::Vector3d arm = world_from_body * wheel.place_in_body;
  const double half_angle = controls.steering * wheel.steering_share / 2;
  Eigen::Quaterniond q = body.world_from_body;
  if (half_angle != 0) q = product(q, Eigen::Quaterniond(std::cos(half_angle), 0, 0, std::sin(half_angle)));
  return {to_array(body.position_in_world + arm),
          {q.w(), q.x(), q.y(), q.z()},
          to_array(body.velocity_in_world + body.angular_velocity_in_world.cross(arm)),
          to_array(body.angular_velocity_in_world)};
}

Eigen::Matrix3d world_from_wheel(const Frame& frame) {
  const Quaternion& q = frame.world_from_wheel;
  return rotation_of(Eigen::Quaterniond(q[0], q[1], q[2], q[3]));
}

}  // namespace groundtruth::rig
