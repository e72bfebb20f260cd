// What the textbook says of sliding, stopping and rolling.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <groundtruth/tests/oracle/rig/closed_forms.hpp>
#include <groundtruth/tests/oracle/rig/random_scenarios.hpp>

namespace groundtruth::rig {
namespace {

constexpr double gravity = 9.81, mu_static = 0.5, mu_dynamic = 0.4;
constexpr Integrator explicit_ones[] = {Integrator::semi_implicit, Integrator::half_kick};

Grip grip_of(const MotionState& state) { return std::get<Contact>(state.wheels[0]).grip; }

TEST(ClosedForms, ASlideAcceleratesByGTimesSineLessMuCosine) {
  for (const Integrator integrator :
       {Integrator::semi_implicit, Integrator::half_kick, Integrator::implicit}) {
    EXPECT_NEAR(slide_error(Body::one_wheel, integrator, 1.0 / 240), 0, 1e-12);
    EXPECT_NEAR(slide_error(Body::three_wheels_that_cannot_turn, integrator, 1.0 / 240), 0, 1e-12);
  }
}

TEST(ClosedForms, RollingFreelyLosesNothingAlongX) {
  for (const Integrator integrator :
       {Integrator::semi_implicit, Integrator::half_kick, Integrator::implicit}) {
    Scenario scenario = one_wheel_on_slope(0, integrator, 1.0 / 240);
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
    Scenario scenario = one_wheel_on_slope(0, Integrator::semi_implicit, h);
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
    Scenario scenario = one_wheel_on_slope(0, integrator, 1.0 / 240);
    scenario.inputs.gravity_in_world[0].points = {{0, 0}, {100, -gravity}};
    const auto states = run_of(scenario, "fast", 24000);
    std::size_t first = 0;
    while (first < states.size() && grip_of(states[first]) == Grip::stick) ++first;
    EXPECT_NEAR(static_cast<double>(first) * scenario.h / 100, mu_static, 2e-3);
  }
}

// Tilted beyond mu_s it slides; between the coefficients it goes on; below mu_k it stops and holds.
TEST(ClosedForms, OnceItSlidesItIsHeldBelowTheDynamicCoefficientOnly) {
  Scenario scenario = one_wheel_on_slope(0, Integrator::semi_implicit, 1.0 / 240);
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
