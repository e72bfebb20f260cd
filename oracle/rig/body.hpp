#pragma once
// Kinematics and dynamics of the body. Private to this folder.

#include <groundtruth/rig/machine.hpp>

namespace groundtruth::rig {

using Vector6 = Eigen::Matrix<double, 6, 1>;  // linear, then angular
using Matrix6 = Eigen::Matrix<double, 6, 6>;

inline Eigen::Vector3d vector_of(const Vector& v) { return {v[0], v[1], v[2]}; }

// Of a quaternion of any length. What follows takes the body's as `world_from_body`, made once a step.
Eigen::Matrix3d rotation_of(const Eigen::Quaterniond& q);

// Both velocities; both momenta per unit of velocity, in world axes. Of a body that does not turn, the
// angular part is a unit that no torque may reach.
Vector6 velocities_of(const BodyState& body);
Matrix6 mass_matrix(const Machine& machine, const Eigen::Matrix3d& world_from_body);

// That a wrench at the centre of mass gives: the mass matrix's inverse, without a matrix.
Vector6 accelerations(const Machine& machine, const Eigen::Matrix3d& world_from_body, const Vector6& wrench);

double kinetic_energy(const Machine& machine, const BodyState& body, const Eigen::Matrix3d& world_from_body);

// Thrust, push, weight, and what turns the axes of rotation.
Vector6 wrench_without_ground(const Machine& machine, const BodyState& body,
                              const Eigen::Matrix3d& world_from_body, const Controls& controls);

// The same body after h seconds at these velocities. A body that does not turn keeps every bit of its
// orientation: quaternions are scaled by powers of two only (Cayley's map, second order in h).
BodyState drifted(const BodyState& body, const Vector6& velocities, double h);

// The wheel's frame as the step is asked with it, and its axes.
Frame frame_of(const BodyState& body, const Eigen::Matrix3d& world_from_body, const MountedWheel& wheel,
               const Controls& controls);
Eigen::Matrix3d world_from_wheel(const Frame& frame);

}  // namespace groundtruth::rig
