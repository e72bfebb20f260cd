#include <groundtruth/rig/builtin_parts.hpp>

#include <cmath>
#include <limits>
#include <memory>

namespace groundtruth::rig {
namespace {

constexpr double damping_ratio = 0.3;

MountedWheel wheel_bearing(double share, double heave_frequency, const Eigen::Vector3d& place_in_body) {
  Wheel wheel;
  wheel.k_xy = wheel.k_z = -share * aircraft_mass * heave_frequency * heave_frequency;
  wheel.d_xy = wheel.d_z = -2 * damping_ratio * share * aircraft_mass * heave_frequency;
  wheel.z_min = 0.2;
  wheel.z_zero = wheel.z_max = 0.8;
  wheel.tyre = "rubber";
  return {wheel, place_in_body};
}

// About x, half a turn: body z is down.
const Eigen::Quaterniond upright(0, 1, 0, 0);

}  // namespace

Machine light_aircraft(double heave_frequency) {
  Machine machine{aircraft_mass, {1000, 1500, 2000}, {}};
  machine.wheels.push_back(wheel_bearing(0.2, heave_frequency, {1.5, 0, 0.3}));
  machine.wheels.push_back(wheel_bearing(0.4, heave_frequency, {-0.375, -1.25, 0.3}));
  machine.wheels.push_back(wheel_bearing(0.4, heave_frequency, {-0.375, 1.25, 0.3}));
  machine.wheels[0].steering_share = 1;
  return machine;
}

Machine one_wheel(double heave_frequency) {
  const auto endless = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  return {aircraft_mass, endless, {wheel_bearing(1, heave_frequency, {0, 0, 0.3})}};
}

Scene scene_of(Shape shape) {
  return {{{"dry", {{"rubber", {0.5, 0.4}}}, 1e7},
           {"wet", {{"rubber", {0.1, 0.1}}}, 1e7},
           {"icy", {{"rubber", {0.001, 0.001}}}, 1e7},
           {"soft", {{"rubber", {0.3, 0.3}}}, 20000.0}},
          std::move(shape)};
}

Shape sloping_ground(double rise, MaterialIndex material) {
  return {Covered{material, std::make_shared<Shape>(Shape{HalfSpace{{-rise, 0, 1}, 0}})}};
}

Shape painted(MaterialIndex material, const HalfSpace& where, Shape over) {
  return {Painted{material, std::make_shared<Shape>(Shape{where}), std::make_shared<Shape>(std::move(over))}};
}

BodyState start_on_slope(double rise, double speed) {
  const double angle = std::atan(rise);
  const Eigen::Vector3d along(std::cos(angle), 0, std::sin(angle)), away(-along.z(), 0, along.x());
  BodyState body;
  const Eigen::Quaterniond pitched(std::cos(angle / 2), 0, -std::sin(angle / 2), 0);
  body.world_from_body = pitched * upright;
  body.position_in_world = height_of_centre * away;
  body.velocity_in_world = speed * along;
  return body;
}

BodyState start_above_ground(double clearance, double speed, double sink) {
  BodyState body;
  body.world_from_body = upright;
  body.position_in_world = {0, 0, height_of_centre + clearance};
  body.velocity_in_world = {speed, 0, -sink};
  return body;
}

Signal constant(double value) { return {{{0, value}}, 0, 0}; }

Inputs plain_inputs(double brake) {
  Inputs inputs;
  inputs.brake = constant(brake);
  inputs.gravity_in_world[2] = constant(-gravity);
  return inputs;
}

}  // namespace groundtruth::rig
