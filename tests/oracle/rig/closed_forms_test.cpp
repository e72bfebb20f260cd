// What the textbook says of sliding, stopping and rolling.

#include <algorithm>
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

// From a step in the middle of the slide, that leaves the body at v: v^2 / (2 mu g) - v h / 2, but for the
// last step's h^2.
TEST(ClosedForms, SemiImplicitEulerStopsShortByHalfAStep) {
  const double deceleration = mu_dynamic * gravity;
  for (const double h : {1.0 / 60, 1.0 / 120, 1.0 / 240}) {
    Scenario scenario = on_slope(0, Integrator::semi_implicit, h);
    scenario.start.velocity_in_world.x() = 30;
    const auto states = run_of(scenario, "fast", static_cast<int>(9 / h));
    const auto rest = std::find_if(states.begin(), states.end(), [](const MotionState& state) {
      return state.body.velocity_in_world.x() <= 0;
    });
    ASSERT_NE(rest, states.end());
    const auto& from = states[static_cast<std::size_t>(2 / h)].body;
    const double v = from.velocity_in_world.x();
    const double path = rest->body.position_in_world.x() - from.position_in_world.x();
    EXPECT_NEAR(path, v * v / (2 * deceleration) - v * h / 2, deceleration * h * h);
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
