// What each profile is there for: honest arithmetic of its kind passes, and a far world loosens nothing.

#include <cmath>

#include <gtest/gtest.h>

#include "judging.hpp"

namespace groundtruth::judge {
namespace {

using namespace cases;

Scene slope() { return {ground_materials(), covered(dry, half_space(1, 2, 3, 0))}; }
const EntryAsk down{{0, 0, 5}, {0, 0, -5}};

template <typename Number>
Answer with_unit_normal() {
  Answer answer = exact_answer(slope(), down);
  Vector& normal = std::get<Border>(std::get<EntryAnswer>(answer)).normal_in_world;
  const Number size = std::sqrt(static_cast<Number>(14));
  for (double& component : normal) component = static_cast<Number>(component) / size;
  return answer;
}

TEST(Profiles, ExactTakesNormalsOfUnitLengthInDoublesButNotInFloats) {
  EXPECT_EQ(difference(slope(), tolerance_of("exact"), down, with_unit_normal<double>()), Difference::none);
  EXPECT_EQ(difference(slope(), tolerance_of("exact"), down, with_unit_normal<float>()), Difference::face);
  EXPECT_EQ(difference(slope(), tolerance_of("float"), down, with_unit_normal<float>()), Difference::none);
}

// A wheel that stands on flat ground, a world away.
StepAsk standing_at(double far, Grip grip, double speed) {
  StepAsk ask;
  ask.wheel = {-1e5, -1e5, -1e3, -1e3, 0.2, 0.8, 0.8, "rubber"};
  ask.frame.position_in_world = {far, far, 0.5};
  ask.frame.world_from_wheel = {0, 1, 0, 0};  // z down
  ask.frame.velocity_in_world = {speed, 0, 0};
  ask.brake = 100;
  ask.h = 0x1p-10;
  ask.state = Contact{grip, {far, far, 0}, {}, {0, 0, 1}, 0.5, 0.4, {}};
  return ask;
}

Answer with_pebble_moved(Answer answer, double metres) {
  auto& stepped = std::get<Stepped>(std::get<StepAnswer>(answer));
  std::get<Contact>(stepped.state).pebble_in_world[0] += metres;
  return answer;
}

Difference when_moved(const char* profile, const StepAsk& ask, double metres) {
  const Scene ground{ground_materials(), covered(dry, half_space(0, 0, 1, 0))};
  return difference(ground, tolerance_of(profile), ask, with_pebble_moved(exact_answer(ground, ask), metres));
}

TEST(Profiles, DoNotLoosenWithTheDistanceFromTheOrigin) {
  for (const double far : {0.0, 1e3, 1e6}) {
    const StepAsk standing = standing_at(far, Grip::stick, 0);
    EXPECT_EQ(when_moved("game", standing, 0.0005), Difference::none) << far;
    EXPECT_EQ(when_moved("game", standing, 0.002), Difference::numbers) << far;
    EXPECT_EQ(when_moved("double", standing, 1e-7), Difference::numbers) << far;
    const StepAsk slipping = standing_at(far, Grip::slip, 50);
    EXPECT_EQ(when_moved("game", slipping, 0.0005), Difference::none) << far;
    EXPECT_EQ(when_moved("game", slipping, 0.1), Difference::numbers) << far;
    EXPECT_EQ(when_moved("double", slipping, 1e-6), Difference::numbers) << far;
  }
}

}  // namespace
}  // namespace groundtruth::judge
