#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include <groundtruth/diagnosis/groups.hpp>

#include "planted_failures.hpp"

namespace groundtruth::diagnosis {
namespace {

std::function<StillFail(const Failure&)> by_kind(const std::vector<std::pair<std::string, Fails>>& causes) {
  return [causes](const Failure& failure) {
    const auto cause = std::ranges::find(causes, failure.kind, [](const auto& one) { return one.first; });
    return each(cause->second);
  };
}

std::size_t members_of(const std::vector<Group>& groups) {
  return std::accumulate(groups.begin(), groups.end(), std::size_t{0},
                         [](std::size_t sum, const Group& group) { return sum + group.members.size(); });
}

TEST(Groups, TwoCausesAreTwoGroupsTheLargerFirst) {
  std::vector<Failure> failures;
  for (const cases::Case& one : messy_cases(slips_and_turns, 4)) failures.push_back({one, "turned"});
  for (const cases::Case& one : messy_cases(has_range_start, 10)) failures.push_back({one, "range"});
  const auto groups = gather(failures, by_kind({{"turned", slips_and_turns}, {"range", has_range_start}}));
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0].kind, "range");
  EXPECT_EQ(groups[0].signature, "entry nothing");
  EXPECT_EQ(groups[0].members.size(), 10u);
  EXPECT_EQ(groups[1].kind, "turned");
  EXPECT_EQ(groups[1].signature, "step from slip nothing");
  EXPECT_EQ(groups[1].members.size(), 4u);
}

TEST(Groups, OneKindWithTwoCausesIsTwoGroups) {
  std::vector<Failure> failures;
  for (const cases::Case& one : messy_cases(has_corner, 2)) failures.push_back({one, "face"});
  for (const cases::Case& one : messy_cases(has_paint, 2, 200)) failures.push_back({one, "face"});
  ASSERT_EQ(failures.size(), 4u);
  const auto still_fail = [](const Failure& failure) {
    return each(has_corner(failure.failing) ? has_corner : has_paint);
  };
  const auto groups = gather(failures, still_fail);
  EXPECT_GE(groups.size(), 2u);
  EXPECT_EQ(members_of(groups), failures.size());
}

TEST(Groups, EveryFailureCountsWhateverTheBudget) {
  std::vector<Failure> failures;
  for (const cases::Case& one : messy_cases(has_corner, 12)) failures.push_back({one, "face"});
  for (const cases::Case& one : messy_cases(has_paint, 6, 200)) failures.push_back({one, "material"});
  for (const cases::Case& one : messy_cases(has_range_start, 6)) failures.push_back({one, "lambda"});
  const auto still_fail =
      by_kind({{"face", has_corner}, {"material", has_paint}, {"lambda", has_range_start}});
  for (const std::size_t most_groups : {std::size_t{1}, std::size_t{2}, std::size_t{10}}) {
    const auto groups = gather(failures, still_fail, {most_groups, {200, std::chrono::milliseconds(500)}});
    EXPECT_LE(groups.size(), std::max(most_groups, std::size_t{3})) << "each of the three kinds has one";
    EXPECT_EQ(members_of(groups), failures.size()) << most_groups;
  }
}

}  // namespace
}  // namespace groundtruth::diagnosis
