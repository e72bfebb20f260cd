#include <groundtruth/tests/oracle/rig/random_scenarios.hpp>

#include <cmath>
#include <limits>
#include <memory>

namespace groundtruth::rig {
namespace {

using properties::Dice;

// A double with all its bits between these.
double between(Dice& dice, double low, double high) {
  return low + (high - low) * (static_cast<double>(dice.bits() >> 11) * 0x1p-53);
}

Shape half_space(const Vector& normal, double offset) { return {HalfSpace{normal, offset}}; }
Shape covered(MaterialIndex material, Shape shape) {
  return {Covered{material, std::make_shared<Shape>(std::move(shape))}};
}

Shape box(const Vector& low, const Vector& high) {
  Intersection faces;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Vector normal{};
    normal[axis] = -1;
    faces.operands.push_back(half_space(normal, -low[axis]));
    normal[axis] = 1;
    faces.operands.push_back(half_space(normal, high[axis]));
  }
  return {faces};
}

Shape random_ground(Dice& dice) {
  const Shape plain = covered(0, half_space({0, 0, 1}, 0));
  switch (dice.whole(0, 3)) {
    case 0:
      return plain;
    case 1:
      return covered(0, half_space({between(dice, -0.3, 0.3), between(dice, -0.3, 0.3), 1}, 0));
    case 2: {
      const double x = between(dice, -3, 3), y = between(dice, -3, 3);
      const Shape kerb = covered(0, box({x, y, -1}, {x + 2, y + 2, between(dice, 0, 0.05)}));
      return {Union{{plain, kerb}}};
    }
    default: {
      const Shape patch = half_space({between(dice, -1, 1), between(dice, -1, 1), 0}, between(dice, -1, 1));
      return {Painted{1, std::make_shared<Shape>(patch), std::make_shared<Shape>(plain)}};
    }
  }
}

Wheel random_wheel(Dice& dice, double share, double h) {
  const double omega = between(dice, 15, 40), damping = dice.pick({0.0, 0.1, 0.5, 1.0});
  Wheel wheel;
  wheel.k_z = -share * omega * omega;
  wheel.k_xy = wheel.k_z * between(dice, 0.5, 1.5);
  wheel.d_z = wheel.d_xy = -2 * damping * share * omega;
  if (h * omega > 0.5) wheel.d_z = wheel.d_xy = 0.5 * wheel.d_z;
  wheel.z_min = 0.2;
  wheel.z_zero = wheel.z_max = 0.8;
  wheel.tyre = "rubber";
  wheel.relocation = dice.pick({Relocation::spring, Relocation::return_mapping});
  return wheel;
}

Machine random_machine(Dice& dice, double h) {
  Machine machine;
  machine.mass = between(dice, 500, 2000);
  machine.inertia.setConstant(std::numeric_limits<double>::infinity());
  if (dice.one_in(2)) {
    machine.wheels = {{random_wheel(dice, machine.mass, h), {0, 0, 0.3}, 1, 1}};
    return machine;
  }
  for (int axis = 0; axis < 3; ++axis) machine.inertia[axis] = machine.mass * between(dice, 0.8, 2);
  const Wheel wheel = random_wheel(dice, machine.mass / 3, h);
  const double track = between(dice, 0.8, 1.4);
  machine.wheels = {
      {wheel, {1.6, 0, 0.3}, 0.5, 1}, {wheel, {-0.4, -track, 0.3}, 1, 0}, {wheel, {-0.4, track, 0.3}, 1, 0}};
  return machine;
}

Signal random_signal(Dice& dice, double low, double high) {
  Signal signal;
  signal.points = {{0, between(dice, low, high)}};
  if (dice.one_in(3)) signal.points.emplace_back(0.5, between(dice, low, high));
  return signal;
}

Vector mirrored(const Vector& v) { return {v[0], -v[1], v[2]}; }
Eigen::Vector3d mirrored(const Eigen::Vector3d& v) { return {v.x(), -v.y(), v.z()}; }
Eigen::Vector3d mirrored_axis(const Eigen::Vector3d& v) { return {-v.x(), v.y(), -v.z()}; }

BodyState mirrored(const BodyState& body) {
  const Eigen::Quaterniond& q = body.world_from_body;
  return {mirrored(body.position_in_world),
          {q.w(), -q.x(), q.y(), -q.z()},
          mirrored(body.velocity_in_world),
          mirrored_axis(body.angular_velocity_in_world)};
}

Signal times(Signal signal, double factor, double time = 1) {
  for (auto& [moment, value] : signal.points) value *= factor, moment *= time;
  signal.amplitude *= factor;
  signal.frequency /= time;
  return signal;
}

// The same solid with each half-space changed.
template <typename Change>
Shape changed(const Shape& shape, const Change& change) {
  const auto all = [&](auto operation) {
    for (Shape& operand : operation.operands) operand = changed(operand, change);
    return Shape{std::move(operation)};
  };
  const auto shared = [&](const Shape& part) { return std::make_shared<Shape>(changed(part, change)); };
  if (const auto* half = std::get_if<HalfSpace>(&shape.expression)) return {change(*half)};
  if (const auto* parts = std::get_if<Union>(&shape.expression)) return all(*parts);
  if (const auto* parts = std::get_if<Intersection>(&shape.expression)) return all(*parts);
  if (const auto* cover = std::get_if<Covered>(&shape.expression))
    return {Covered{cover->material, shared(*cover->over)}};
  if (const auto* paint = std::get_if<Painted>(&shape.expression))
    return {Painted{paint->material, shared(*paint->where), shared(*paint->over)}};
  return shape;
}

BodyState in_units(const BodyState& body, const Units& units) {
  const double speed = units.length / units.time;
  return {body.position_in_world * units.length, body.world_from_body, body.velocity_in_world * speed,
          body.angular_velocity_in_world / units.time};
}

}  // namespace

Scenario random_scenario(Dice& dice) {
  Scenario scenario;
  scenario.h = dice.pick({1.0 / 60, 1.0 / 240, 1.0 / 1000});
  scenario.machine = random_machine(dice, scenario.h);
  scenario.integrator = dice.pick({Integrator::semi_implicit, Integrator::half_kick, Integrator::implicit});
  scenario.scene = {{Material{"dry", {{"rubber", {0.5, 0.4}}}, std::nullopt},
                     Material{"ice", {{"rubber", {0.05, 0.03}}}, std::nullopt}},
                    random_ground(dice)};
  const double lean = dice.one_in(2) ? 0.05 : 0.0;
  scenario.start.world_from_body = {between(dice, -lean, lean), 1, between(dice, -lean, lean) * 5,
                                    between(dice, -lean, lean)};
  scenario.start.position_in_world = {between(dice, -1, 1), between(dice, -1, 1), between(dice, 1.05, 1.4)};
  const double speed = dice.pick({0.0, 2.0, 20.0});
  scenario.start.velocity_in_world = {between(dice, 0, speed), between(dice, -speed, speed) / 5,
                                      between(dice, -1, 0)};
  const double weight = scenario.machine.mass * 9.81;
  scenario.inputs.brake = dice.one_in(3) ? Signal{} : random_signal(dice, 0, weight);
  scenario.inputs.steering = random_signal(dice, -0.2, 0.2);
  scenario.inputs.push_in_world[1] = random_signal(dice, -weight / 4, weight / 4);
  scenario.inputs.thrust_in_body[0] = random_signal(dice, -weight / 4, weight / 4);
  scenario.inputs.gravity_in_world[2].points = {{0, -9.81}};
  return scenario;
}

Scenario random_level_scenario(Dice& dice) {
  Scenario scenario = random_scenario(dice);
  while (scenario.machine.turns()) scenario = random_scenario(dice);
  scenario.start.world_from_body = {0, 1, 0, 0};
  scenario.scene.shape = covered(0, half_space({0, 0, 1}, 0));
  const Signal brake = scenario.inputs.brake;
  scenario.inputs = {};
  scenario.inputs.brake = brake;
  scenario.inputs.gravity_in_world[2].points = {{0, -9.81}};
  return scenario;
}

Scenario mirrored(const Scenario& scenario) {
  Scenario other = scenario;
  for (MountedWheel& wheel : other.machine.wheels) wheel.place_in_body = mirrored(wheel.place_in_body);
  other.start = mirrored(scenario.start);
  other.scene.shape = changed(scenario.scene.shape, [](const HalfSpace& half) {
    return HalfSpace{mirrored(half.normal), half.offset};
  });
  other.inputs.steering = times(scenario.inputs.steering, -1);
  for (auto* vector :
       {&other.inputs.thrust_in_body, &other.inputs.push_in_world, &other.inputs.gravity_in_world})
    (*vector)[1] = times((*vector)[1], -1);
  return other;
}

MotionState mirrored(const MotionState& state) {
  MotionState other{mirrored(state.body), state.wheels, state.steps};
  for (WheelState& wheel : other.wheels)
    if (auto* contact = std::get_if<Contact>(&wheel)) {
      contact->pebble_in_world = mirrored(contact->pebble_in_world);
      contact->pebble_velocity_in_world = mirrored(contact->pebble_velocity_in_world);
      contact->normal_in_world = mirrored(contact->normal_in_world);
    }
  return other;
}

Scenario in_units(const Scenario& scenario, const Units& units) {
  const auto& [length, time, mass] = units;
  const double acceleration = length / (time * time), force = mass * acceleration;
  Scenario other = scenario;
  other.h *= time;
  other.machine.mass *= mass;
  other.machine.inertia *= mass * length * length;
  for (MountedWheel& mounted : other.machine.wheels) {
    mounted.place_in_body *= length;
    Wheel& wheel = mounted.wheel;
    for (double* k : {&wheel.k_xy, &wheel.k_z}) *k *= force / length;
    for (double* d : {&wheel.d_xy, &wheel.d_z}) *d *= mass / time;
    for (double* z : {&wheel.z_min, &wheel.z_zero, &wheel.z_max}) *z *= length;
  }
  other.start = in_units(scenario.start, units);
  other.scene.shape = changed(scenario.scene.shape, [metres = length](const HalfSpace& half) {
    return HalfSpace{half.normal, half.offset * metres};
  });
  other.inputs.brake = times(scenario.inputs.brake, force, time);
  other.inputs.steering = times(scenario.inputs.steering, 1, time);
  for (std::size_t i = 0; i < 3; ++i) {
    other.inputs.thrust_in_body[i] = times(scenario.inputs.thrust_in_body[i], force, time);
    other.inputs.push_in_world[i] = times(scenario.inputs.push_in_world[i], force, time);
    other.inputs.gravity_in_world[i] = times(scenario.inputs.gravity_in_world[i], acceleration, time);
  }
  return other;
}

MotionState in_units(const MotionState& state, const Units& units) {
  MotionState other{in_units(state.body, units), state.wheels, state.steps};
  for (WheelState& wheel : other.wheels)
    if (auto* contact = std::get_if<Contact>(&wheel))
      for (std::size_t i = 0; i < 3; ++i) {
        contact->pebble_in_world[i] *= units.length;
        contact->pebble_velocity_in_world[i] *= units.length / units.time;
      }
  return other;
}

std::vector<MotionState> run_of(const Scenario& scenario, const std::string& engine, int steps) {
  const auto ground = implementations::make_engine(engine)->on(scenario.scene);
  Motion motion(scenario.machine, *ground, scenario.integrator, scenario.h);
  MotionState state = scenario.state_at_start();
  std::vector<MotionState> states;
  for (int i = 0; i < steps; ++i) {
    const Controls controls = scenario.inputs.at(i * scenario.h);
    if (motion.advance(state, controls).halt != Halt::none) break;
    states.push_back(state);
  }
  return states;
}

bool is_same(const MotionState& a, const MotionState& b) {
  return a.body.position_in_world == b.body.position_in_world &&
         a.body.world_from_body.coeffs() == b.body.world_from_body.coeffs() &&
         a.body.velocity_in_world == b.body.velocity_in_world &&
         a.body.angular_velocity_in_world == b.body.angular_velocity_in_world && a.wheels == b.wheels;
}

}  // namespace groundtruth::rig
