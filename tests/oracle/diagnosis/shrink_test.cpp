#include <chrono>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <groundtruth/cases/ask_source.hpp>
#include <groundtruth/cases/builtin_scenes.hpp>
#include <groundtruth/cases/shape_parts.hpp>
#include <groundtruth/text/ask_text.hpp>

#include "planted_failures.hpp"

namespace groundtruth::diagnosis {
namespace {

constexpr Budget generous{20000, std::chrono::milliseconds(60000)};

std::string text_of(const cases::Case& one) {
  return write_scene_line(one.scene) + "\n" + write_ask("1", one.ask);
}

// By the reader of text, which knows the domain on its own.
bool can_be_read(const cases::Case& one) {
  const Origin nowhere{};
  return std::holds_alternative<SceneLine>(read_line(write_scene_line(one.scene), nowhere)) &&
         std::holds_alternative<AskLine>(read_line(write_ask("1", one.ask), nowhere));
}

std::vector<Shrunk> shrunk(const std::vector<cases::Case>& failing, Fails fails) {
  std::vector<Shrunk> result;
  for (const cases::Case& one : failing) {
    result.push_back(shrink(one, each(fails), generous));
    EXPECT_TRUE(fails(result.back().smallest));
    EXPECT_TRUE(result.back().is_minimum);
  }
  return result;
}

TEST(Shrink, KeepsThreeHalfSpacesOfACorner) {
  const auto cases = messy_cases(has_corner, 6);
  ASSERT_GE(cases.size(), 4u);
  for (const Shrunk& one : shrunk(cases, has_corner)) {
    EXPECT_EQ(one.after.leaves, 3u) << text_of(one.smallest);
    EXPECT_LE(one.after.parts, 4u) << text_of(one.smallest);
  }
}

TEST(Shrink, LeavesNothingButTheStartOfTheRange) {
  const auto cases = messy_cases(has_range_start, 10);
  ASSERT_GE(cases.size(), 10u);
  for (const Shrunk& one : shrunk(cases, has_range_start)) {
    EXPECT_EQ(one.after.parts, 1u) << text_of(one.smallest);
    EXPECT_LE(one.after.numbers, 1.25) << text_of(one.smallest);
  }
}

TEST(Shrink, FindsTheSmallestBrakeAtTheLimitOfFriction) {
  cases::Case failing{"",
                      cases::builtin_scenes().front().build().front(),
                      ClipAsk{{-3.7, 18.3, 4096.5}, {0.3, -0.2, -0.9}, 0.75, 0.75 * 4096.5, 0.05},
                      {},
                      ""};
  const Shrunk one = shrink(failing, each(has_brake_at_limit), generous);
  EXPECT_EQ(one.after.parts, 1u);
  const auto& ask = std::get<ClipAsk>(one.smallest.ask);
  EXPECT_EQ(ask.force_in_wheel, (Vector{0, 0, 1})) << text_of(one.smallest);
  EXPECT_EQ(ask.friction, 1);
  EXPECT_EQ(ask.brake, 1);
}

TEST(Shrink, KeepsAPaintAndOneHalfSpaceUnderIt) {
  const auto cases = messy_cases(has_paint, 6, 200);
  ASSERT_GE(cases.size(), 2u);
  for (const Shrunk& one : shrunk(cases, has_paint)) {
    EXPECT_EQ(one.after.leaves, 1u) << text_of(one.smallest);
    EXPECT_EQ(one.after.parts, 4u) << text_of(one.smallest);  // paint, region, half-space, materials
  }
}

TEST(Shrink, KeepsASlipAndOneTurn) {
  const auto cases = messy_cases(slips_and_turns, 6);
  ASSERT_GE(cases.size(), 6u);
  for (const Shrunk& one : shrunk(cases, slips_and_turns)) {
    EXPECT_EQ(one.after.parts, 3u) << text_of(one.smallest);
    const Vector& omega = std::get<StepAsk>(one.smallest.ask).frame.angular_velocity_in_world;
    EXPECT_EQ(std::abs(omega[0]) + std::abs(omega[1]) + std::abs(omega[2]), 1) << text_of(one.smallest);
  }
}

TEST(Shrink, DoesTheSameAgain) {
  for (const cases::Case& one : messy_cases(has_corner, 2)) {
    const Shrunk first = shrink(one, each(has_corner), generous),
                 again = shrink(one, each(has_corner), generous);
    EXPECT_EQ(text_of(first.smallest), text_of(again.smallest));
    EXPECT_EQ(first.asks, again.asks);
  }
}

RC_GTEST_PROP(Shrink, NeverLeavesTheDomainAndOnlyGetsSmaller, ()) {
  const auto builtin = *rc::gen::elementOf(std::vector<std::string>{"house", "ramp", "degenerate", "nested"});
  const std::vector<Scene> scenes = cases::find_builtin_scene(builtin)->build();
  const Scene scene = scenes[*rc::gen::inRange<std::size_t>(0, scenes.size())];
  const auto bits = *rc::gen::arbitrary<std::uint64_t>();
  const cases::Case failing{"", scene, cases::AskSource(scene, bits).next().ask, {}, ""};
  RC_PRE(size_of(failing).leaves < 40);
  std::size_t asked = 0;
  // Fails or not by chance, but always alike.
  const StillFail by_chance = [&](std::span<const cases::Case> candidates) {
    std::vector<bool> result;
    for (const cases::Case& candidate : candidates) {
      RC_ASSERT(can_be_read(candidate));
      result.push_back(std::hash<std::string>{}(text_of(candidate)) % 3 == bits % 3);
    }
    asked += candidates.size();
    return result;
  };
  const Budget small{400, std::chrono::milliseconds(60000)};
  const Shrunk one = shrink(failing, by_chance, small);
  RC_ASSERT(asked == one.asks);
  RC_ASSERT(asked <= small.most_asks);
  RC_ASSERT(one.after == size_of(one.smallest));
  RC_ASSERT(one.after <= one.before);
}

TEST(Shrink, BringsATownDownToACornerInTime) {
  const Scene town = cases::find_builtin_scene("town")->build().front();
  cases::AskSource source(town, 3, {1, 0, 0});
  cases::Case failing{"", town, source.next().ask, {}, ""};
  while (!has_corner(failing)) failing.ask = source.next().ask;
  const auto begin = std::chrono::steady_clock::now();
  const Shrunk one = shrink(failing, each(has_corner));
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  EXPECT_LE(one.after.leaves, 3u) << seconds.count() << " s, " << one.asks << " asks";
  EXPECT_TRUE(has_corner(one.smallest));
  EXPECT_LT(seconds.count(), 4.0);
  RecordProperty("asks", static_cast<int>(one.asks));
}

TEST(Shrink, StopsInTimeWhereOnlyTheWholeTownFails) {
  const Scene town = cases::find_builtin_scene("town")->build().front();
  const cases::Case failing{"", town, EntryAsk{{0.3, 0.7, 9}, {0, 1, -2}}, {}, ""};
  const auto begin = std::chrono::steady_clock::now();
  const Shrunk one = shrink(
      failing, each([](const cases::Case& with) { return cases::leaf_count(with.scene.shape) == 7001; }));
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  EXPECT_EQ(cases::leaf_count(one.smallest.scene.shape), 7001u);
  EXPECT_LT(seconds.count(), 4.0);
}

}  // namespace
}  // namespace groundtruth::diagnosis
