// What cannot be answered is refused by both engines, in words that name what is at fault.

#include <gtest/gtest.h>

#include <groundtruth/definition/clip.hpp>
#include <groundtruth/definition/step.hpp>
#include <groundtruth/exact/clip.hpp>
#include <groundtruth/exact/step.hpp>
#include <groundtruth/tests/properties/step_cases.hpp>

namespace groundtruth::properties {
namespace {

std::vector<std::string> reasons(const Shape& shape, const StepAsk& ask) {
  const Scene scene{palette(), shape};
  std::vector<std::string> result;
  for (const StepAnswer& answer :
       {exact::step(exact::Scene(scene), ask).answer, definition::step(definition::Scene(scene), ask)}) {
    const auto* refusal = std::get_if<Refusal>(&answer);
    result.push_back(refusal ? refusal->reason : "not refused: " + outcome(answer));
  }
  return result;
}

void expect_words(const std::vector<std::string>& reasons, std::initializer_list<std::string> words) {
  for (const std::string& reason : reasons)
    for (const std::string& word : words)
      EXPECT_NE(reason.find(word), std::string::npos) << reason << "; no " << word;
}

const StepAsk slipping = plain_step(contact(Grip::stick, {3, 0, 1}));

TEST(StepRefusal, AContactWithoutMaterialNamesTheLeaf) {
  const Shape bare = any_of({half_space(1, 0, 0, -50), half_space(0, 0, -1, -1)});
  expect_words(reasons(bare, plain_step(Free{})), {"leaf 1", "material"});
  expect_words(reasons(bare, slipping), {"leaf 1", "material"});
}

TEST(StepRefusal, AMaterialWithoutFrictionForTheTyreNamesLeafMaterialAndTyre) {
  const Shape metal = any_of({half_space(1, 0, 0, -50), half_space(1, 0, 0, -60), ground_at(1, 1)});
  expect_words(reasons(metal, plain_step(Free{})), {"leaf 2", "metal-only", "rubber"});
  expect_words(reasons(metal, slipping), {"leaf 2", "metal-only", "rubber"});
}

TEST(StepRefusal, OnlyThePaintAtTheContactCounts) {
  const Shape partly_metal = painted(1, half_space(1, 0, 0, 0.25), ground_at(1));
  expect_words(reasons(partly_metal, plain_step(Free{})), {"leaf 0", "metal-only"});
  EXPECT_EQ(outcome(partly_metal, slipping), "slip");
}

TEST(StepRefusal, AForceOutsideTheRangeOfDoublesIsNamed) {
  StepAsk ask = plain_step(contact(Grip::stick, {0, 0x1p1000, 1}));
  ask.wheel.k_xy = -0x1p24;
  std::get<Contact>(ask.state).static_friction = 0x1p1023;  // of 4 N
  expect_words(reasons({Nothing{}}, ask), {"force[1]"});
}

TEST(StepRefusal, AVelocityOutsideTheRangeOfDoublesIsNamed) {
  StepAsk ask = slipping;
  ask.h = 0x1p-1074;
  expect_words(reasons(ground_at(1), ask), {"velocity[0]"});
}

TEST(StepRefusal, APebbleOutsideTheRangeOfDoublesIsNamed) {
  StepAsk ask = plain_step(contact(Grip::stick, {0, 0x1p1023, 1}));
  ask.wheel.k_xy = -0x1p-1000;
  ask.wheel.d_xy = -0x1p1000;
  std::get<Contact>(ask.state).pebble_velocity_in_world = {0, 0x1p-1000, 0};
  std::get<Contact>(ask.state).static_friction = 0x1p1000;
  ask.frame.position_in_world = {0, 0x1p1023, 0};
  ask.brake = 0;
  // F_y = d_xy w_y = -1 N is borne; F_x = k_xy p_x is not, with no brake: a slip to y = F_y / k_xy = 2^1000
  // of the frame, which still is a double. At k_xy = -2^-1074 it goes to 2^1074.
  std::get<Contact>(ask.state).pebble_in_world[0] = 1;
  ask.wheel.k_xy = -0x1p-1074;
  expect_words(reasons(ground_at(1), ask), {"pebble[1]"});
}

TEST(StepRefusal, AClippedForceOutsideTheRangeOfDoublesIsNamed) {
  // F.n / n^2 = -m / 3: the normal part is (1, 1, 4) m / 3, and without friction nothing else is left.
  const double m = 0x1.fffffffffffffp1023;
  const ClipAsk ask{{m, m, m}, {-1, -1, -4}, 0, 0};
  for (const ClipAnswer& answer : {exact::clip(ask).answer, definition::clip(ask)}) {
    const auto* refusal = std::get_if<Refusal>(&answer);
    ASSERT_NE(refusal, nullptr);
    expect_words({refusal->reason}, {"force[2]"});
  }
}

}  // namespace
}  // namespace groundtruth::properties
