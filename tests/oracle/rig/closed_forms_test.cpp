// What the textbook says of sliding, stopping and rolling.

#include <cmath>

#include <gtest/gtest.h>

#include <groundtruth/stability/parked.hpp>
#include <groundtruth/tests/oracle/rig/random_scenarios.hpp>

namespace groundtruth::rig {
namespace {

using stability::Parked;
using stability::Wheels;

constexpr double gravity = 9.81, mu_static = 0.5, mu_dynamic = 0.4;
constexpr Integrator explicit_ones[] = {Integrator::semi_implicit, Integrator::half_kick};

Scenario on_slope(double slope, Integrator integrator, double h) {
  Parked parked;
  parked.slope = slope;
  parked.integrator = integrator;
  parked.relocation = Relocation::return_mapping;
  parked.h_omega = h * 20;
  return stability::scenario_of(parked, 1);
}

double speed_along(const MotionState& state, double slope) {
  const Eigen::Vector3d downhill = Eigen::Vector3d(-1, 0, -slope) / std::hypot(1, slope);
  return state.body.velocity_in_world.dot(downhill);
}

Grip grip_of(const MotionState& state) { return std::get<Contact>(state.wheels[0]).grip; }

// The path from v0 to rest on level ground with brakes on, from the first step that slips.
double stop_distance(Integrator integrator, double h, double v0) {
  Scenario scenario = on_slope(0, integrator, h);
  scenario.start.velocity_in_world.x() = v0;
  const auto states = run_of(scenario, "fast", static_cast<int>(1.5 * v0 / (mu_dynamic * gravity) / h));
  for (const MotionState& state : states)
    if (state.body.velocity_in_world.x() <= 0) return state.body.position_in_world.x();
  return states.back().body.position_in_world.x();
}

TEST(ClosedForms, ASlideAcceleratesByGTimesSineLessMuCosine) {
  const double slope = 0.7, cosine = 1 / std::hypot(1, slope);
  const double expected = gravity * cosine * (slope - mu_dynamic);
  for (const Integrator integrator :
       {Integrator::semi_implicit, Integrator::half_kick, Integrator::implicit}) {
    const Scenario scenario = on_slope(slope, integrator, 1.0 / 240);
    const auto states = run_of(scenario, "fast", 4000);
    const double gained = speed_along(states[3999], slope) - speed_along(states[2999], slope);
    EXPECT_NEAR(gained / (1000 * scenario.h) / expected, 1, 1e-12);
  }
}

TEST(ClosedForms, RollingFreelyLosesNothingAlongX) {
  for (const Integrator integrator :
       {Integrator::semi_implicit, Integrator::half_kick, Integrator::implicit}) {
    Scenario scenario = on_slope(0, integrator, 1.0 / 240);
    scenario.start.velocity_in_world.x() = 30;
    scenario.inputs.brake = {};
    for (const MotionState& state : run_of(scenario, "fast", 1000))
      ASSERT_EQ(state.body.velocity_in_world.x(), 30);
  }
}

// Semi-implicit Euler stops short by v h / 2; the half kick is second order.
TEST(ClosedForms, StoppingDistances) {
  const double v0 = 30, expected = v0 * v0 / (2 * mu_dynamic * gravity);
  double previous = 0;
  for (const double h : {1.0 / 60, 1.0 / 120, 1.0 / 240}) {
    const double plain = stop_distance(Integrator::semi_implicit, h, v0) - expected;
    const double kicked = stop_distance(Integrator::half_kick, h, v0) - expected;
    RecordProperty("h", std::to_string(h));
    std::printf("h %.6f: semi-implicit %.6g (+vh/2 = %.3g), half kick %.6g, ratio %.3g\n", h, plain,
                plain + v0 * h / 2, kicked, previous / kicked);
    previous = kicked;
  }
}

// Gravity turns by 0.01 rad/s.
TEST(ClosedForms, ASlowTiltSlipsAtTheStaticCoefficient) {
  for (const Integrator integrator : explicit_ones) {
    Scenario scenario = on_slope(0, integrator, 1.0 / 240);
    scenario.inputs.gravity_in_world[0].points = {{0, 0}, {100, -gravity}};
    const auto states = run_of(scenario, "fast", 24000);
    std::size_t first = 0;
    while (first < states.size() && grip_of(states[first]) == Grip::stick) ++first;
    EXPECT_NEAR(static_cast<double>(first) * scenario.h / 100, mu_static, 2e-3);
  }
}

// Tilted beyond mu_s it slides; between the coefficients it goes on; below mu_k it stops and holds.
TEST(ClosedForms, OnceItSlidesItIsHeldBelowTheDynamicCoefficientOnly) {
  Scenario scenario = on_slope(0, Integrator::semi_implicit, 1.0 / 240);
  const auto tilt = [](double tangent) { return -tangent * gravity; };
  scenario.inputs.gravity_in_world[0].points = {{0, tilt(0.3)},  {2, tilt(0.45)},   {4, tilt(0.45)},
                                                {5, tilt(0.55)}, {5.5, tilt(0.45)}, {8, tilt(0.45)},
                                                {9, tilt(0.2)}};
  const auto states = run_of(scenario, "fast", 240 * 30);
  ASSERT_EQ(states.size(), 240U * 30);
  EXPECT_EQ(grip_of(states[240 * 4]), Grip::stick);
  EXPECT_EQ(grip_of(states[240 * 8 - 1]), Grip::slip);
  EXPECT_EQ(grip_of(states.back()), Grip::stick);
}

}  // namespace
}  // namespace groundtruth::rig
