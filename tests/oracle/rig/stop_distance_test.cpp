// The path to rest against v^2 / (2 mu g): first order for semi-implicit Euler, which is short by v h / 2;
// second order for the half-kick start.

#include <cmath>

#include <gtest/gtest.h>

#include <groundtruth/tests/oracle/rig/closed_forms.hpp>

namespace groundtruth::rig {
namespace {

TEST(StopDistance, IsSecondOrderWithAHalfKickAndFirstOrderWithout) {
  constexpr double speed = 30, deceleration = 0.4 * 9.81;
  double last_plain = 0, last_kicked = 0;
  for (int halvings = 0; halvings < 5; ++halvings) {
    const double h = stop_step(halvings);
    const double plain = stop_error(Integrator::semi_implicit, halvings);
    const double kicked = stop_error(Integrator::half_kick, halvings);
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
