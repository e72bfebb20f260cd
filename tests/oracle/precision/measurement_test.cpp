#include <groundtruth/precision/measurement.hpp>

#include <algorithm>

#include <gtest/gtest.h>

#include <groundtruth/cases/ask_source.hpp>
#include <groundtruth/cases/builtin_scenes.hpp>
#include <groundtruth/cases/random.hpp>

namespace groundtruth::precision {
namespace {

TierResult tier(double ns, double worst_ulps, std::size_t wrong) {
  TierResult result;
  result.asks = 100;
  result.worst_ulps = worst_ulps;
  result.wrong = wrong;
  result.nanoseconds.median = ns;
  return result;
}

std::vector<bool> fronts(std::vector<TierResult> results) {
  mark_front(results);
  std::vector<bool> on_front;
  for (const TierResult& result : results) on_front.push_back(result.is_on_front);
  return on_front;
}

TEST(TheFront, HoldsWhatNothingBeatsInBoth) {
  EXPECT_EQ(fronts({tier(10, 100, 0), tier(20, 1, 0), tier(30, 2, 0), tier(40, 0.5, 0)}),
            (std::vector<bool>{true, true, false, true}));
}

TEST(TheFront, PutsAWrongDecisionBelowEveryError) {
  EXPECT_EQ(fronts({tier(10, 0.5, 1), tier(20, 1e9, 0)}), (std::vector<bool>{true, true}));
  EXPECT_EQ(fronts({tier(20, 0.5, 1), tier(10, 1e9, 0)}), (std::vector<bool>{false, true}));
}

TEST(TheFront, TakesHalfAnUlpForAsGoodAsDoublesCanBe) {
  EXPECT_EQ(fronts({tier(10, 0.4999, 0), tier(20, 0.49, 0)}), (std::vector<bool>{true, false}));
}

TEST(TheFront, LeavesOutWhatWasOmitted) {
  TierResult omitted = tier(0, 0, 0);
  omitted.omitted = "no roots";
  EXPECT_EQ(fronts({omitted, tier(10, 1, 0)}), (std::vector<bool>{false, true}));
}

const TierResult& result_of(const std::vector<TierResult>& results, const std::string& name) {
  return *std::find_if(results.begin(), results.end(),
                       [&](const TierResult& result) { return result.tier == name; });
}

constexpr Effort little{0.01, 0.001, 3};

TEST(ASample, BearsThePlacesFromWhichItsAsksCanBeMadeAgain) {
  const std::vector<Scene> pack = cases::find_builtin_scene("nested")->build();
  const Sample sample = draw("nested", pack, tiers::AskKind::entry, Population::hostile, 7, 40);
  ASSERT_EQ(sample.cases.size(), 40U);
  for (const Case& one : sample.cases) {
    const cases::AskSource source(pack[one.part], cases::seed_of_part(7, one.part));
    const Ask again = source.ask_at(one.index).ask;
    EXPECT_EQ(std::get<EntryAsk>(again).from, std::get<EntryAsk>(one.ask).from);
    EXPECT_EQ(std::get<EntryAsk>(again).lambda_last, std::get<EntryAsk>(one.ask).lambda_last);
  }
}

TEST(Measuring, FindsTheEnginesThatRoundOnceWithinHalfAnUlp) {
  const std::vector<Scene> pack = cases::find_builtin_scene("ramp")->build();
  for (const auto kind : {tiers::AskKind::entry, tiers::AskKind::clip, tiers::AskKind::step})
    for (const auto population : {Population::ordinary, Population::hostile}) {
      const auto results = measure(draw("ramp", pack, kind, population, 1, 60), little);
      for (const char* engine : {"fast", "exact", "definition"}) {
        const TierResult& result = result_of(results, engine);
        EXPECT_EQ(result.wrong + result.undecided, 0U) << engine;
        EXPECT_LE(result.worst_ulps, 0.5) << engine;
        EXPECT_GT(result.nanoseconds.least, 0) << engine;
        EXPECT_LE(result.nanoseconds.least, result.nanoseconds.median) << engine;
      }
    }
}

TEST(Measuring, FindsWhatFloatsGetWrong) {
  const std::vector<Scene> pack = cases::find_builtin_scene("far-town")->build();
  const auto results =
      measure(draw("far-town", pack, tiers::AskKind::entry, Population::hostile, 1, 100), little);
  EXPECT_GT(result_of(results, "float").wrong, 10U);
  EXPECT_TRUE(result_of(results, "float").first_wrong.has_value());
  EXPECT_GT(result_of(results, "double").worst_ulps, result_of(results, "double-double").worst_ulps);
}

}  // namespace
}  // namespace groundtruth::precision
