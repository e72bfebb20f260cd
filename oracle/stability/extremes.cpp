#include <groundtruth/stability/extremes.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <random>

#include <groundtruth/rig/simulation.hpp>
#include <groundtruth/stability/parked.hpp>

namespace groundtruth::stability {
namespace {

// How the machine's body is held: along the slope, or level over it, so that the struts lean against the
// ground.
enum class Stance { along, level };

// What the scenarios are made of.
struct Numbers {
  double mass = 1200, k = 1e6, d = 1e4, h = 1.0 / 240, slope = 0.05, friction = 0.5, brake = 1e6;
  double away = 0;  // of the world's origin, along all axes
  double sink = 0, forward = 0;
  double gravity = 9.81;
  double strut = 0.6;  // m, of travel
  Stance stance = Stance::along;
  Wheels wheels = Wheels::three;
  rig::Integrator integrator = rig::Integrator::semi_implicit;
  Relocation relocation = Relocation::spring;
};

void scale_to(const Numbers& numbers, rig::Machine& machine) {
  const double ratio = numbers.mass / machine.mass;
  machine.mass = numbers.mass;
  machine.inertia *= ratio;
  for (rig::MountedWheel& mounted : machine.wheels) {
    mounted.wheel.k_xy = mounted.wheel.k_z = -numbers.k;
    mounted.wheel.d_xy = mounted.wheel.d_z = -numbers.d;
    mounted.wheel.z_min = mounted.wheel.z_zero - numbers.strut;
  }
}

// Pebbles touch the ground when the machine starts; of a machine on three wheels that is level, one does at
// most.
rig::Scenario scenario_with(const Numbers& numbers) {
  const double pitch = numbers.stance == Stance::level ? 0 : numbers.slope;
  const Parked base{numbers.wheels, 0.1, 0.3, pitch, numbers.integrator, numbers.relocation};
  rig::Scenario scenario = scenario_of(base, 1);
  scale_to(numbers, scenario.machine);
  scenario.h = numbers.h;
  const Eigen::Vector3d up = Eigen::Vector3d(-pitch, 0, 1).normalized(), ahead(up.z(), 0, -up.x());
  const Eigen::Vector3d origin = Eigen::Vector3d::Constant(numbers.away);
  scenario.start.position_in_world = origin + 1.1 * up;
  scenario.start.velocity_in_world = numbers.forward * ahead - numbers.sink * up;
  const HalfSpace ground{{-numbers.slope, 0, 1}, numbers.away - numbers.slope * numbers.away};
  scenario.scene.shape = {Covered{0, std::make_shared<Shape>(Shape{ground})}};
  scenario.scene.materials[0].friction_by_tyre["rubber"] = {numbers.friction, 0.8 * numbers.friction};
  scenario.inputs.brake.points = {{0, numbers.brake}};
  scenario.inputs.gravity_in_world[2].points = {{0, -numbers.gravity}};
  return scenario;
}

struct End {
  std::string name;
  std::function<void(Numbers&)> set;
};

const std::vector<End>& ends() {
  static const std::vector<End> all{
      {"mass 1 kg", [](Numbers& n) { n.mass = 1; }},
      {"mass 600 t", [](Numbers& n) { n.mass = 6e5; }},
      {"mass 600 t, k 1e8 N/m", [](Numbers& n) { n.mass = 6e5, n.k = 1e8, n.d = 1e6; }},
      {"k 1e12 N/m", [](Numbers& n) { n.k = 1e12; }},
      {"k 1e12 N/m, no damping", [](Numbers& n) { n.k = 1e12, n.d = 0; }},
      {"k 1e12 N/m, d 1e12 N s/m", [](Numbers& n) { n.k = n.d = 1e12; }},
      {"k 1e300 N/m", [](Numbers& n) { n.k = 1e300; }},
      {"k 1 N/m", [](Numbers& n) { n.k = 1, n.d = 0; }},
      {"h 1 us", [](Numbers& n) { n.h = 1e-6; }},
      {"h 1/15 s", [](Numbers& n) { n.h = 1.0 / 15; }},
      {"h 1e-300 s", [](Numbers& n) { n.h = 1e-300; }},
      {"h 1e300 s", [](Numbers& n) { n.h = 1e300; }},
      {"slope 10", [](Numbers& n) { n.slope = 10; }},
      {"slope 9.99 under a level machine", [](Numbers& n) { n.slope = 9.99, n.stance = Stance::level; }},
      {"slope 10.01 under a level machine", [](Numbers& n) { n.slope = 10.01, n.stance = Stance::level; }},
      {"coordinates 6.4e6 m", [](Numbers& n) { n.away = 6.4e6; }},
      {"coordinates 6.4e6 m, k 1e12 N/m", [](Numbers& n) { n.away = 6.4e6, n.k = 1e12; }},
      {"coordinates 1e17 m", [](Numbers& n) { n.away = 1e17; }},
      {"friction 0", [](Numbers& n) { n.friction = 0; }},
      {"friction 10", [](Numbers& n) { n.friction = 10, n.forward = 30; }},
      {"friction 10, slope 5", [](Numbers& n) { n.friction = 10, n.slope = 5; }},
      {"brake 0, slope 0.05", [](Numbers& n) { n.brake = 0; }},
      {"brake 1e300 N at 30 m/s", [](Numbers& n) { n.brake = 1e300, n.forward = 30; }},
      {"brake 5e-324 N", [](Numbers& n) { n.brake = 5e-324, n.forward = 30; }},
      {"subnormal forces", [](Numbers& n) { n.mass = 1e-310, n.k = 1e-308, n.d = 1e-309; }},
      {"subnormal weight", [](Numbers& n) { n.gravity = 1e-312, n.sink = 0.1; }},
      {"no gravity", [](Numbers& n) { n.gravity = 0, n.sink = 1; }},
      {"sink 20 m/s", [](Numbers& n) { n.sink = 20; }},
      {"sink 20 m/s, soft and long struts", [](Numbers& n) { n.sink = 20, n.k = 1e5, n.strut = 50; }},
      {"sink 20 m/s, k 1e9 N/m", [](Numbers& n) { n.sink = 20, n.k = 1e9; }},
      {"300 m/s ahead", [](Numbers& n) { n.forward = 300; }},
  };
  return all;
}

constexpr rig::Integrator integrators[] = {rig::Integrator::semi_implicit, rig::Integrator::half_kick,
                                           rig::Integrator::implicit};
constexpr Relocation relocations[] = {Relocation::spring, Relocation::return_mapping};

bool is_finite(const rig::Moment& moment) {
  const rig::BodyState& body = moment.state.body;
  const auto finite = [](const Vector& v) {
    return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
  };
  bool all = body.position_in_world.allFinite() && body.velocity_in_world.allFinite() &&
             body.angular_velocity_in_world.allFinite() && body.world_from_body.coeffs().allFinite() &&
             body.world_from_body.coeffs().any();
  for (const auto& force : moment.record.forces_in_world) all = all && force.allFinite();
  for (const WheelState& wheel : moment.state.wheels)
    if (const auto* contact = std::get_if<Contact>(&wheel))
      all = all && finite(contact->pebble_in_world) && finite(contact->pebble_velocity_in_world);
  return all && std::isfinite(moment.record.border_violation);
}

}  // namespace

std::vector<Extreme> chosen_extremes() {
  std::vector<Extreme> extremes;
  for (const End& end : ends())
    for (const rig::Integrator integrator : integrators)
      for (const Relocation relocation : relocations)
        for (const Wheels wheels : {Wheels::one, Wheels::three}) {
          Numbers numbers;
          numbers.integrator = integrator;
          numbers.relocation = relocation;
          numbers.wheels = wheels;
          end.set(numbers);
          extremes.push_back({end.name, scenario_with(numbers)});
        }
  return extremes;
}

Extreme random_extreme(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto part = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  const auto between = [&part](double low, double high) { return low * std::pow(high / low, part()); };
  const auto or_zero = [&random](double value) { return random() % 4 == 0 ? 0 : value; };
  Numbers numbers;
  numbers.mass = between(1, 6e5);
  numbers.k = between(1, 1e12);
  numbers.d = or_zero(between(1e-3, 4) * std::sqrt(numbers.k * numbers.mass));
  numbers.h = between(1e-6, 1.0 / 15);
  numbers.slope = or_zero(between(1e-3, 10));
  numbers.friction = or_zero(between(1e-3, 10));
  numbers.brake = or_zero(random() % 4 == 0 ? 1e300 : between(1e-3, 10) * numbers.mass);
  numbers.away = or_zero(between(1, 6.4e6));
  numbers.sink = or_zero(between(1e-2, 20));
  numbers.forward = or_zero(between(1e-2, 100));
  numbers.strut = random() % 2 == 0 ? 0.6 : 60;
  numbers.stance = random() % 2 == 0 ? Stance::along : Stance::level;
  numbers.wheels = random() % 2 == 0 ? Wheels::one : Wheels::three;
  numbers.integrator = integrators[random() % 3];
  numbers.relocation = relocations[random() % 2];
  return {"random", scenario_with(numbers)};
}

Ordeal ordeal_of(const Extreme& extreme, std::uint64_t steps) {
  rig::Scenario scenario = extreme.scenario;
  scenario.duration = scenario.h * static_cast<double>(steps);
  Ordeal ordeal;
  ordeal.name = extreme.name;
  ordeal.integrator = scenario.integrator;
  auto before = std::chrono::steady_clock::now();
  const auto observe = [&](const rig::Moment& moment) {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> taken = now - before;
    before = now;
    ordeal.slowest_step_s = std::max(ordeal.slowest_step_s, taken.count());
    ordeal.all_is_finite = ordeal.all_is_finite && is_finite(moment);
  };
  const rig::Summary summary = rig::play(scenario, "fast", rig::Repetitions::skipped, observe);
  ordeal.steps = summary.steps;
  ordeal.halt = summary.outcome;
  ordeal.reason = summary.reason;
  ordeal.energy_rise = summary.energy_rise;
  ordeal.border_violation = summary.border_violation;
  return ordeal;
}

}  // namespace groundtruth::stability
