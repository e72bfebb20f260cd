// Explained clips and steps end as the exact engine answers, on the corpus and on generated asks.

#include <gtest/gtest.h>

#include "explaining.hpp"

namespace groundtruth::explanation {
namespace {

Answer exact_answer(const cases::Case& asked) {
  return implementations::make_engine("exact")->on(asked.scene)->answer(asked.ask).answer;
}

std::vector<cases::Case> asks_of(const cases::AskMix& mix, std::size_t count) {
  std::vector<cases::Case> all = cases::corpus();
  const Scene ramp = cases::find_builtin_scene("ramp")->build().front();
  cases::AskSource source(ramp, 20261126, mix);
  for (std::size_t i = 0; i < count; ++i)
    all.push_back({"ramp:" + std::to_string(i), ramp, source.next().ask, {}, {}});
  return all;
}

TEST(ExplainedClip, FindsTheCaseOfTheExactAnswer) {
  std::size_t clips = 0;
  for (const cases::Case& one : asks_of({0, 1, 0}, 300)) {
    const auto* ask = std::get_if<ClipAsk>(&one.ask);
    if (ask == nullptr) continue;
    ++clips;
    const ClipCase found = facts_of(*ask).which;
    const Answer exact = exact_answer(one);
    const auto& answer = std::get<ClipAnswer>(exact);
    EXPECT_EQ(found == ClipCase::too_steep, std::holds_alternative<TooSteep>(answer)) << one.id;
    const auto* clipped = std::get_if<Clipped>(&answer);
    EXPECT_EQ(found == ClipCase::stick, clipped != nullptr && clipped->grip == Grip::stick) << one.id;
  }
  EXPECT_GT(clips, 300U);
}

TEST(ExplainedClip, NamesTheCornerOfTheBorder) {
  EXPECT_EQ(std::get<ClipFacts>(explained("clip/case-2-corner").facts).which, ClipCase::corner);
  EXPECT_EQ(std::get<ClipFacts>(explained("clip/case-1").facts).which, ClipCase::band);
  EXPECT_EQ(std::get<ClipFacts>(explained("clip/case-3").facts).which, ClipCase::circle);
}

// The last question that is answered leads to where the engine ends.
TEST(ExplainedStep, LeadsWhereTheExactEngineEnds) {
  std::size_t steps = 0;
  for (const cases::Case& one : asks_of({0, 0, 1}, 300)) {
    const auto* ask = std::get_if<StepAsk>(&one.ask);
    if (ask == nullptr) continue;
    const Answer exact = exact_answer(one);
    const StepFacts facts = facts_of(one.scene, *ask, std::get<StepAnswer>(exact));
    if (facts.to == "refused") continue;
    ++steps;
    ASSERT_FALSE(facts.questions.empty()) << one.id;
    EXPECT_EQ(facts.questions.back().leads_to, facts.to) << one.id;
  }
  EXPECT_GT(steps, 250U);
}

TEST(ExplainedStep, TellsLiftOffByTheStrutsEnd) {
  const Explanation lifted = explained("contact/lifted-off");
  const auto& facts = std::get<StepFacts>(lifted.facts);
  EXPECT_EQ(facts.from, "stick");
  EXPECT_EQ(facts.to, "free");
  EXPECT_EQ(facts.questions.size(), 1U);
}

}  // namespace
}  // namespace groundtruth::explanation
