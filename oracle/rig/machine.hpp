#pragma once
// A rigid body on wheels, and what drives it. Units are SI. Body axes are like a wheel's: x forward, y right,
// z down; the body's origin is its centre of mass. World axes are free; gravity says where down is.

#include <vector>

#include <Eigen/Geometry>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::rig {

struct MountedWheel {
  Wheel wheel;
  Eigen::Vector3d place_in_body;  // of the wheel frame's origin
  double brake_share = 1;         // of Controls::brake
  double steering_share = 0;      // of Controls::steering
};

struct Machine {
  double mass = 1;  // kg
  // kg m^2, about the body axes: these are principal. All infinite: the body does not turn.
  Eigen::Vector3d inertia = Eigen::Vector3d::Ones();
  std::vector<MountedWheel> wheels;

  bool turns() const { return inertia.allFinite(); }
};

// What acts on the machine during a step, besides the ground.
struct Controls {
  double brake = 0;                                          // N, of each wheel, times its share
  double steering = 0;                                       // rad about the wheel's z, times its share
  Eigen::Vector3d thrust_in_body = Eigen::Vector3d::Zero();  // N, at the centre of mass
  Eigen::Vector3d push_in_world = Eigen::Vector3d::Zero();   // N, at the centre of mass
  Eigen::Vector3d gravity_in_world = Eigen::Vector3d(0, 0, -9.81);  // m/s^2
};

// The orientation is a quaternion of any length but zero: only its direction means something.
struct BodyState {
  Eigen::Vector3d position_in_world = Eigen::Vector3d::Zero();
  Eigen::Quaterniond world_from_body = Eigen::Quaterniond::Identity();
  Eigen::Vector3d velocity_in_world = Eigen::Vector3d::Zero();
  Eigen::Vector3d angular_velocity_in_world = Eigen::Vector3d::Zero();
};

struct MotionState {
  BodyState body;
  std::vector<WheelState> wheels;  // one a wheel of the machine
  std::uint64_t steps = 0;         // taken so far
};

}  // namespace groundtruth::rig
