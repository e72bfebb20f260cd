// The path to rest against v^2 / (2 mu g): first order for semi-implicit Euler, which is short by v h / 2;
// second order for the half-kick start.

#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "runs.hpp"

namespace groundtruth::rig {
namespace {

constexpr double speed = 30, deceleration = 0.4 * 9.81;
constexpr double exact_path = speed * speed / (2 * deceleration);

// The body's furthest place: there its velocity is 0. The time to rest is a whole number of steps and a
// third, or two thirds: whenever h is halved, the stop falls as near to a step, in parts of h. A damper along
// the ground would let go up to two steps early: second order too, but with a factor that changes with the
// phase.
double path_error(Integrator integrator, int halvings) {
  Scenario scenario = testing::builtin("stop-one");
  scenario.integrator = integrator;
  scenario.h = speed / deceleration / ((1000 + 1.0 / 3) * (1 << halvings));
  const double heave = 0.4 / scenario.h, stiffness = -1200 * heave * heave;
  Wheel& wheel = scenario.machine.wheels[0].wheel;
  wheel.k_xy = wheel.k_z = stiffness;
  wheel.d_xy = 0;
  wheel.d_z = -0.6 * 1200 * heave;
  scenario.start.position_in_world.z() = 1.1 - 9.81 / (heave * heave);
  scenario.duration = 8;
  double furthest = 0;
  bool moves_on = true;  // later it swings on its spring
  play(scenario, "fast", Repetitions::played, [&](const Moment& moment) {
    moves_on = moves_on && moment.state.body.velocity_in_world.x() > 0;
    if (moves_on) furthest = moment.state.body.position_in_world.x();
  });
  return furthest - exact_path;
}

TEST(StopDistance, IsSecondOrderWithAHalfKickAndFirstOrderWithout) {
  std::printf("%12s %22s %22s\n", "h, s", "semi-implicit, m", "half-kick, m");
  double last_plain = 0, last_kicked = 0;
  for (int halvings = 0; halvings < 5; ++halvings) {
    const double h = speed / deceleration / ((1000 + 1.0 / 3) * (1 << halvings));
    const double plain = path_error(Integrator::semi_implicit, halvings);
    const double kicked = path_error(Integrator::half_kick, halvings);
    std::printf("%12.6g %22.10g %22.10g\n", h, plain, kicked);
    EXPECT_NEAR(plain, -speed * h / 2, deceleration * h * h);
    EXPECT_NEAR(kicked, -deceleration / 2 * (h / 3) * (h / 3), 1e-9);
    if (halvings > 0) {
      EXPECT_NEAR(last_plain / plain, 2, 0.01);
      EXPECT_NEAR(last_kicked / kicked, 4, 0.01);
    }
    last_plain = plain;
    last_kicked = kicked;
  }
}

}  // namespace
}  // namespace groundtruth::rig
