#include <groundtruth/campaign/campaign.hpp>

#include <gtest/gtest.h>

#include <groundtruth/cases/builtin_scenes.hpp>

namespace groundtruth::campaign {
namespace {

using judge::Difference;

Plan plan_of(std::string_view scene, const std::string& engine, unsigned jobs = 1) {
  return {cases::find_builtin_scene(scene)->build(), {"exact", engine}, 7, 600, jobs};
}

Tally against_exact(const Plan& plan) {
  return run(plan, [](std::uint64_t) {})[1];
}

TEST(Campaign, TheDefinitionAgrees) {
  const Tally tally = against_exact(plan_of("ramp", "definition"));
  EXPECT_GT(tally.asks(), 300U);
  EXPECT_EQ(tally.disagreements(), 0U);
}

// A campaign that cannot see a wrong engine proves nothing.
TEST(Campaign, SeesEachKindOfError) {
  EXPECT_GT(against_exact(plan_of("house", "as-written:band-test-wheel-x")).count(Difference::stick_slip),
            0U);
  EXPECT_GT(against_exact(plan_of("runway", "as-written:normal-by-order")).count(Difference::face), 0U);
  EXPECT_GT(
      against_exact(plan_of("degenerate", "as-written:single-pass-intersection")).count(Difference::hit_miss),
      0U);
  EXPECT_GT(against_exact(plan_of("house", "as-written:no-liftoff")).count(Difference::state), 0U);
  EXPECT_GT(against_exact(plan_of("house", "as-written:force-on-frame-sign")).count(Difference::numbers), 0U);
}

TEST(Campaign, CountsTheSameWithAnyNumberOfJobs) {
  const Tally one = against_exact(plan_of("degenerate", "as-written"));
  const Tally three = against_exact(plan_of("degenerate", "as-written", 3));
  for (std::size_t i = 0; i < judge::number_of_differences; ++i) {
    EXPECT_EQ(one.count(static_cast<Difference>(i)), three.count(static_cast<Difference>(i)));
  }
  EXPECT_EQ(one.worst_vector().place, three.worst_vector().place);
  ASSERT_EQ(one.examples().size(), three.examples().size());
  for (std::size_t i = 0; i < one.examples().size(); ++i) {
    EXPECT_EQ(one.examples()[i].place, three.examples()[i].place);
  }
}

TEST(Campaign, PutsEveryAskOnce) {
  std::uint64_t last = 0;
  const auto tallies =
      run(plan_of("degenerate", "fast", 2), [&](std::uint64_t done) { last = std::max(last, done); });
  EXPECT_EQ(last, 600U);
  EXPECT_EQ(tallies[0].asks(), 600U);
  EXPECT_EQ(tallies[1].asks(), 600U);
}

TEST(Campaign, CountsWhatASlowEngineIsSpared) {
  const Tally tally = against_exact(plan_of("ramp", "definition"));
  EXPECT_GT(tally.left_out(), 0U);
  EXPECT_EQ(tally.asks() + tally.left_out(), 600U);
}

TEST(Campaign, AnExampleCanBeAskedAgain) {
  const Plan plan = plan_of("house", "as-written:band-test-wheel-x");
  const Tally tally = against_exact(plan);
  ASSERT_FALSE(tally.examples().empty());
  const auto& [difference, place] = tally.examples().front();
  const Ask ask = asks_for(plan, place.part).ask_at(place.index).ask;
  const Scene& scene = plan.pack[place.part];
  const auto exact = implementations::make_engine("exact")->on(scene)->answer(ask);
  const auto wrong = implementations::make_engine(plan.engines[1])->on(scene)->answer(ask);
  EXPECT_EQ(judge::compare({wrong.answer, wrong.evidence}, {exact.answer, exact.evidence}).difference,
            difference);
}

}  // namespace
}  // namespace groundtruth::campaign
