#include <groundtruth/judge/difference.hpp>

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace groundtruth::judge {
namespace {

Comparison compared(const Answer& got, const Answer& exact, const Evidence& got_evidence = {},
                    const Evidence& exact_evidence = {}) {
  return compare({got, got_evidence}, {exact, exact_evidence});
}

Difference difference(const Answer& got, const Answer& exact) { return compared(got, exact).difference; }

const Border border{0.5, 3, {0, 0, 1}, 1};
const Contact contact{Grip::slip, {1, 2, 3}, {4, 5, 6}, {0, 0, 1}, 0.5, 0.4, 10.0};

template <typename Value, typename Change>
Value changed(Value value, const Change& change) {
  change(value);
  return value;
}

TEST(Difference, OfAnAnswerToItselfIsNone) {
  const Answer answers[] = {EntryAnswer{Miss{}},
                            EntryAnswer{border},
                            ClipAnswer{TooSteep{}},
                            ClipAnswer{Refusal{"force[0] leaves the range"}},
                            StepAnswer{Stepped{contact, {1, 2, 3}}},
                            StepAnswer{StepFailure::wheel_broken}};
  for (const Answer& answer : answers) {
    EXPECT_EQ(difference(answer, answer), Difference::none);
    EXPECT_EQ(compared(answer, answer).vector_ulps, 0);
  }
}

TEST(Difference, OfEntryAnswers) {
  EXPECT_EQ(difference(EntryAnswer{Miss{}}, EntryAnswer{border}), Difference::hit_miss);
  EXPECT_EQ(difference(EntryAnswer{Inside{0.5}}, EntryAnswer{Miss{}}), Difference::hit_miss);
  EXPECT_EQ(difference(EntryAnswer{Inside{0.5}}, EntryAnswer{border}), Difference::face);
  EXPECT_EQ(difference(EntryAnswer{changed(border, [](Border& b) { b.leaf = 4; })}, EntryAnswer{border}),
            Difference::face);
  EXPECT_EQ(
      difference(EntryAnswer{changed(border, [](Border& b) { b.material.reset(); })}, EntryAnswer{border}),
      Difference::material);
  EXPECT_EQ(difference(EntryAnswer{changed(border, [](Border& b) { b.lambda = 0x1.0000000000001p-1; })},
                       EntryAnswer{border}),
            Difference::lambda);
}

TEST(Difference, OfClipAnswers) {
  const Clipped clipped{Grip::slip, {1, 2, 3}};
  EXPECT_EQ(difference(ClipAnswer{TooSteep{}}, ClipAnswer{clipped}), Difference::stick_slip);
  EXPECT_EQ(difference(ClipAnswer{Clipped{Grip::stick, {1, 2, 3}}}, ClipAnswer{clipped}),
            Difference::stick_slip);
  EXPECT_EQ(difference(ClipAnswer{Clipped{Grip::slip, {1, 2, 4}}}, ClipAnswer{clipped}), Difference::numbers);
  EXPECT_EQ(difference(ClipAnswer{Refusal{"too large"}}, ClipAnswer{clipped}), Difference::refusal);
}

TEST(Difference, OfStepAnswers) {
  const Stepped stepped{contact, {7, 8, 9}};
  const auto with = [&](const auto& change) {
    return StepAnswer{Stepped{changed(contact, change), {7, 8, 9}}};
  };
  EXPECT_EQ(difference(StepAnswer{StepFailure::wheel_broken}, StepAnswer{stepped}), Difference::state);
  EXPECT_EQ(difference(StepAnswer{StepFailure::wheel_broken}, StepAnswer{StepFailure::surface_gave_way}),
            Difference::state);
  EXPECT_EQ(difference(StepAnswer{Stepped{Free{}, {7, 8, 9}}}, StepAnswer{stepped}), Difference::state);
  EXPECT_EQ(difference(with([](Contact& c) { c.grip = Grip::stick; }), StepAnswer{stepped}),
            Difference::state);
  EXPECT_EQ(difference(with([](Contact& c) { c.normal_in_world[0] = 1; }), StepAnswer{stepped}),
            Difference::face);
  EXPECT_EQ(difference(with([](Contact& c) { c.maximum_force.reset(); }), StepAnswer{stepped}),
            Difference::material);
  EXPECT_EQ(difference(with([](Contact& c) { c.pebble_in_world[2] = 9; }), StepAnswer{stepped}),
            Difference::numbers);
  EXPECT_EQ(difference(StepAnswer{Stepped{contact, {7, 8, 0}}}, StepAnswer{stepped}), Difference::numbers);
  EXPECT_EQ(difference(StepAnswer{Refusal{"a"}}, StepAnswer{Refusal{"b"}}), Difference::refusal);
}

TEST(Difference, EvidenceCountsWhereItIsGiven) {
  const Answer answer = EntryAnswer{border};
  const Evidence exact{"1/2", {3, 5}, {}};
  EXPECT_EQ(compared(answer, answer, {}, exact).difference, Difference::none);
  EXPECT_EQ(compared(answer, answer, exact, exact).difference, Difference::none);
  EXPECT_EQ(compared(answer, answer, {"1/2", {3}, {}}, exact).difference, Difference::face);
  EXPECT_EQ(compared(answer, answer, {"1/3", {3, 5}, {}}, exact).difference, Difference::lambda);
}

TEST(Ulps, AreThoseOfTheExactDouble) {
  const auto lambda_ulps = [](double got, double exact) {
    return compared(EntryAnswer{Inside{got}}, EntryAnswer{Inside{exact}}).lambda_ulps;
  };
  EXPECT_EQ(lambda_ulps(1 + 0x3p-52, 1), 3);
  EXPECT_EQ(lambda_ulps(1 - 0x1p-53, 1), 0.5) << "the binade below is finer";
  EXPECT_EQ(lambda_ulps(0x1p-1073, 0), 2);
}

TEST(Ulps, OfAVectorAreThoseOfItsLargestComponent) {
  const auto ulps = compared(ClipAnswer{Clipped{Grip::slip, {0x1p-40, 2, -1024}}},
                             ClipAnswer{Clipped{Grip::slip, {0, 2, -1024}}});
  EXPECT_EQ(ulps.vector_ulps, 0x1p-40 / 0x1p-42);
}

}  // namespace
}  // namespace groundtruth::judge
