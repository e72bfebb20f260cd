#include <groundtruth/precision/comparison.hpp>

#include <gtest/gtest.h>

namespace groundtruth::precision {
namespace {

constexpr double threshold = 0.25;

std::vector<TierFigure> figures(double plain_ns, double fast_ns, double worst_ulps = 0.5,
                                std::size_t unanswered = 0) {
  return {{"town/entry/hostile", "double", 100, 7, 1000, plain_ns},
          {"town/entry/hostile", "fast", 100, unanswered, worst_ulps, fast_ns}};
}

std::string found(const std::vector<TierFigure>& before, const std::vector<TierFigure>& now) {
  std::string text;
  for (const Regression& regression : regressions(before, now, threshold))
    text += regression.tier + ": " + regression.what + "; ";
  return text;
}

TEST(Comparison, FindsNothingInEqualReports) { EXPECT_EQ(found(figures(20, 100), figures(20, 100)), ""); }

TEST(Comparison, FindsWhatBecameSlowerPastTheThreshold) {
  EXPECT_EQ(found(figures(20, 100), figures(20, 124)), "");
  EXPECT_EQ(found(figures(20, 100), figures(20, 126)), "fast: time relative to double; ");
}

TEST(Comparison, LeavesOutThatTheWholeMachineIsSlower) {
  EXPECT_EQ(found(figures(20, 100), figures(60, 300)), "");
}

TEST(Comparison, FindsWhatBecameLessExact) {
  EXPECT_EQ(found(figures(20, 100, 0.4), figures(20, 100, 0.5)), "") << "both are correctly rounded";
  EXPECT_EQ(found(figures(20, 100, 0.5), figures(20, 100, 1)), "fast: worst error, ulp; ");
  EXPECT_EQ(found(figures(20, 100), figures(20, 100, 0.5, 1)), "fast: share without a right answer; ");
}

TEST(Comparison, FindsWhatIsMissing) {
  EXPECT_EQ(found(figures(20, 100), {figures(20, 100)[0]}), "fast: missing; ");
}

}  // namespace
}  // namespace groundtruth::precision
