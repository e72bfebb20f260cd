// Asks in which a scale is zero, and tolerances that vanish beside 1.

#include <gtest/gtest.h>

#include "judging.hpp"

namespace groundtruth::judge {
namespace {

const Scene no_scene{{}, {Nothing{}}};

Tolerance with_decision(double relative) {
  Tolerance tolerance = tolerance_of("double");
  tolerance.relative_decision = relative;
  return tolerance;
}

ClipAnswer clipped(Grip grip, const Vector& force) { return Clipped{grip, force}; }

TEST(NothingToDivideBy, ForceThatDoesNotPress) {
  const ClipAsk ask{{3, 4, 0}, {0, 0, -1}, 0.5, 100};
  EXPECT_EQ(difference(no_scene, tolerance_of("double"), ask, clipped(Grip::slip, {})), Difference::none);
  EXPECT_EQ(difference(no_scene, tolerance_of("double"), ask, clipped(Grip::slip, {3, 4, 0})),
            Difference::numbers);
  EXPECT_EQ(difference(no_scene, tolerance_of("double"), ask, clipped(Grip::stick, {0, 0, 0})),
            Difference::stick_slip);
  EXPECT_EQ(difference(no_scene, tolerance_of("double"), ask, TooSteep{}), Difference::stick_slip);
}

TEST(NothingToDivideBy, AllZero) {
  const ClipAsk ask{{0, 0, 0}, {0, 0, -1}, 0, 0};
  for (const Profile& profile : profiles()) {
    EXPECT_EQ(difference(no_scene, profile.tolerance, ask, clipped(Grip::stick, {})), Difference::none);
    EXPECT_EQ(difference(no_scene, profile.tolerance, ask, clipped(Grip::slip, {})), Difference::stick_slip);
    EXPECT_EQ(difference(no_scene, profile.tolerance, ask, clipped(Grip::stick, {1e-9, 0, 0})),
              Difference::numbers);
  }
}

TEST(NothingToDivideBy, NoNormal) {
  const ClipAsk ask{{1, 2, 3}, {0, 0, 0}, 0.5, 1};
  for (const Profile& profile : profiles()) {
    EXPECT_EQ(difference(no_scene, profile.tolerance, ask, TooSteep{}), Difference::none);
    EXPECT_EQ(difference(no_scene, profile.tolerance, ask, clipped(Grip::slip, {})), Difference::stick_slip);
  }
}

TEST(NothingToDivideBy, RelativeTolerancesBelowARounding) {
  const ClipAsk ask{{3, 0x1.0000000000001p+2, -10}, {0, 0, -1}, 0.5, 100};  // an ulp outside the circle
  for (const double relative : {1e-15, 1e-16, 1e-17, 1e-300}) {
    const Tolerance tolerance = with_decision(relative);
    EXPECT_EQ(difference(no_scene, tolerance, ask, exact_answer(no_scene, ask)), Difference::none);
    EXPECT_EQ(difference(no_scene, tolerance, ask, TooSteep{}), Difference::stick_slip);
    EXPECT_EQ(difference(no_scene, tolerance, ask, clipped(Grip::slip, {3, 3, -10})), Difference::numbers);
  }
  EXPECT_EQ(difference(no_scene, with_decision(1e-300), ask, clipped(Grip::stick, ask.force_in_wheel)),
            Difference::stick_slip);
  EXPECT_EQ(difference(no_scene, with_decision(1e-15), ask, clipped(Grip::stick, ask.force_in_wheel)),
            Difference::none);
}

}  // namespace
}  // namespace groundtruth::judge
