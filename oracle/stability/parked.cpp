#include <groundtruth/stability/parked.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace groundtruth::stability {
namespace {

constexpr double mass = 1200, gravity = 9.81;
constexpr double axle = 0.3, z_min = 0.2, z_zero = 0.8;
constexpr double nudge = 1e-4;  // rad/s, of roll and yaw: else symmetry keeps them at 0
constexpr double longest_step = 1.0 / 60, slowest_frequency = 20;

std::vector<Eigen::Vector3d> places_of(Wheels wheels) {
  if (wheels == Wheels::one) return {{0, 0, axle}};
  return {{1.6, 0, axle}, {-0.8, -1.2, axle}, {-0.8, 1.2, axle}};
}

Eigen::Vector3d inertia_of(Wheels wheels) {
  if (wheels == Wheels::one) return Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  return {1000, 1500, 2000};
}

Scene slope_of(double tangent) {
  const Shape solid{HalfSpace{{-tangent, 0, 1}, 0}};
  return {{Material{"dry", {{"rubber", {0.5, 0.4}}}, std::nullopt}},
          Shape{Covered{0, std::make_shared<Shape>(solid)}}};
}

// z down, x uphill.
Eigen::Quaterniond standing_on(double tangent) {
  const double half = std::atan(tangent) / 2;
  return Eigen::Quaterniond(std::cos(half), 0, -std::sin(half), 0) * Eigen::Quaterniond(0, 1, 0, 0);
}

// The fastest mode's frequency in parts of sqrt(3 k / m): of three equal springs in all directions at
// the pebbles, z_zero below the places.
double fastest_mode_of_three() {
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  Matrix6 masses = Matrix6::Zero(), springs = Matrix6::Zero();
  masses.diagonal() << Eigen::Vector3d::Constant(mass), inertia_of(Wheels::three);
  for (Eigen::Vector3d pebble : places_of(Wheels::three)) {
    pebble.z() += z_zero;
    Eigen::Matrix<double, 3, 6> motion;
    motion << Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Zero();
    for (int axis = 0; axis < 3; ++axis) motion.col(3 + axis) = Eigen::Vector3d::Unit(axis).cross(pebble);
    springs += mass / 3 * motion.transpose() * motion;
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix6> modes(springs, masses, Eigen::EigenvaluesOnly);
  return std::sqrt(modes.eigenvalues().maxCoeff());
}

// A wheel's first step makes contact and bears nothing yet, in explicit integrators: how long that lets the
// machine fall, in steps.
double free_fall_of(rig::Integrator integrator) {
  switch (integrator) {
    case rig::Integrator::semi_implicit:
      return 1;
    case rig::Integrator::half_kick:
      return 0.5;
    case rig::Integrator::implicit:
      return 0;
  }
  return 0;
}

}  // namespace

rig::Scenario scenario_of(const Parked& parked, std::uint64_t steps) {
  rig::Scenario scenario;
  scenario.h = std::min(longest_step, parked.h_omega / slowest_frequency);
  scenario.duration = scenario.h * static_cast<double>(steps);
  scenario.integrator = parked.integrator;
  const double omega = parked.h_omega / scenario.h;
  const std::vector<Eigen::Vector3d> places = places_of(parked.wheels);
  const double share = mass / static_cast<double>(places.size());
  Wheel wheel;
  wheel.k_xy = wheel.k_z = -share * omega * omega;
  wheel.d_xy = wheel.d_z = -2 * parked.damping_ratio * share * omega;
  wheel.z_min = z_min;
  wheel.z_zero = wheel.z_max = z_zero;
  wheel.tyre = "rubber";
  wheel.relocation = parked.relocation;
  scenario.machine = {mass, inertia_of(parked.wheels), {}};
  for (const Eigen::Vector3d& place : places) scenario.machine.wheels.push_back({wheel, place});
  scenario.scene = slope_of(parked.slope);
  const double cosine = 1 / std::hypot(1, parked.slope), sine = parked.slope * cosine;
  const double height = axle + z_zero - gravity * cosine / (omega * omega);
  scenario.start.world_from_body = standing_on(parked.slope);
  scenario.start.position_in_world = Eigen::Vector3d(-sine, 0, cosine) * height;
  scenario.start.velocity_in_world.z() = gravity * free_fall_of(parked.integrator) * scenario.h;
  if (parked.wheels == Wheels::three) scenario.start.angular_velocity_in_world = {nudge, 0, nudge};
  scenario.inputs.brake.points = {{0, 1e6}};
  scenario.inputs.gravity_in_world[2].points = {{0, -gravity}};
  return scenario;
}

double explicit_limit(Wheels wheels, double damping_ratio) {
  const double ratio = wheels == Wheels::one ? 1 : fastest_mode_of_three();
  const double z = damping_ratio * ratio;
  return 2 / (std::hypot(1, z) + z) / ratio;
}

}  // namespace groundtruth::stability
