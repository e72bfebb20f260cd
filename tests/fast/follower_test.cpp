// A warm start changes no answer, whatever was asked before.

#include <groundtruth/fast/follower.hpp>

#include <bit>
#include <random>

#include <gtest/gtest.h>
#include <groundtruth/cases/ask_source.hpp>
#include <groundtruth/cases/builtin_scenes.hpp>
#include <groundtruth/cases/random.hpp>
#include <groundtruth/cases/scene_builders.hpp>
#include <groundtruth/fast/entry_point.hpp>
#include <groundtruth/tests/fast/shapes.hpp>

namespace groundtruth::fast {
namespace {

std::vector<groundtruth::Scene> scenes() {
  std::vector<groundtruth::Scene> all;
  for (const char* name : {"house", "ramp", "degenerate", "nested", "far-town"})
    for (groundtruth::Scene& scene : cases::find_builtin_scene(name)->build())
      all.push_back(std::move(scene));
  all.push_back(cases::runway_of(30));
  all.push_back(cases::hills_of(6));
  all.push_back(cases::town_of(40, 3));
  return all;
}

std::uint64_t bits_of_lambda(const EntryAnswer& answer) {
  if (const auto* border = std::get_if<Border>(&answer)) return std::bit_cast<std::uint64_t>(border->lambda);
  if (const auto* inside = std::get_if<Inside>(&answer)) return std::bit_cast<std::uint64_t>(inside->lambda);
  return 0;
}

::testing::AssertionResult follows(Follower& follower, const Scene& scene, const EntryAsk& ask) {
  const EntryAnswer got = follower.entry_point(ask), expected = entry_point(scene, ask);
  if (got == expected && bits_of_lambda(got) == bits_of_lambda(expected))
    return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "from " << ask.from[0] << " " << ask.from[1] << " " << ask.from[2];
}

// The ask, and then ones that creep away from it, by steps that are fractions of its length or of a metre.
std::vector<EntryAsk> wandering(EntryAsk ask, std::mt19937_64& random, int count) {
  std::uniform_int_distribution<int> step(-2, 2);
  std::vector<EntryAsk> asks;
  for (int i = 0; i < count; ++i) {
    asks.push_back(ask);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double length = random() % 2 == 0 ? 1 : ask.to[axis] - ask.from[axis];
      const double way = 0x1p-5 * step(random) * length;
      ask.from[axis] += way;
      ask.to[axis] += way;
    }
  }
  return asks;
}

TEST(Followers, GiveTheAnswersOfOneByOneToAsksThatFollowEachOther) {
  std::mt19937_64 random(1);
  std::uint64_t seed = 0;
  for (const groundtruth::Scene& scene : scenes()) {
    const Scene compiled = compile(scene);
    Follower follower(compiled);
    cases::AskSource source(scene, ++seed, {1, 0, 0});
    for (int start = 0; start < 60; ++start)
      for (const EntryAsk& ask : wandering(std::get<EntryAsk>(source.next().ask), random, 12))
        ASSERT_TRUE(follows(follower, compiled, ask)) << "scene " << seed;
  }
}

TEST(Followers, GiveTheAnswersOfOneByOneToAsksThatDoNot) {
  std::uint64_t seed = 100;
  for (const groundtruth::Scene& scene : scenes()) {
    const Scene compiled = compile(scene);
    Follower follower(compiled);
    cases::AskSource source(scene, ++seed, {1, 0, 0});
    for (int i = 0; i < 300; ++i)
      ASSERT_TRUE(follows(follower, compiled, std::get<EntryAsk>(source.next().ask))) << "scene " << seed;
  }
}

TEST(Followers, GiveTheAnswersOfOneByOneToWheelsThatRollThroughATown) {
  const Scene town = compile(cases::town_of(400, 1)), hills = compile(cases::hills_of(30));
  for (const Scene* scene : {&town, &hills}) {
    Follower follower(*scene);
    for (int i = 0; i < 20000; ++i) {
      const double x = 0.0203 * i - 3, y = 0.011 * i;
      ASSERT_TRUE(follows(follower, *scene, {{x, y, 4.1}, {x + 0.03, y + 0.01, -0.7}})) << i;
    }
  }
}

TEST(Neighbourhoods, HoldWhatMayBeMetInABoxAndOnlyTheFacesThatItReaches) {
  const Shape wall = box({3, 0, 0}, {4, 8, 8});
  const Scene scene = compile({{}, unite({half_space({0, 0, 1}, 0), wall, box({50, 0, 0}, {51, 1, 1})})});
  Neighbourhood near;
  ASSERT_TRUE(near.look_around(scene, {{0, 0, -1}, {2, 2, 2}}));
  EXPECT_EQ(near.cells().cells.size(), 1u);
  ASSERT_TRUE(near.look_around(scene, {{3.5, 1, 1}, {5, 2, 2}}));
  ASSERT_EQ(near.cells().cells.size(), 1u);
  EXPECT_EQ(near.cells().cells[0].leaf_count, 1u);
  EXPECT_EQ(near.cells().leaf_at(near.cells().cells[0], 0), 2u);
  ASSERT_TRUE(near.look_around(scene, {{3, 1, 1}, {4, 2, 2}})) << "its border belongs to a box";
  EXPECT_EQ(near.cells().cells[0].leaf_count, 2u);
}

TEST(Neighbourhoods, SettleMaterialsWherePaintDoesNotReach) {
  const Shape painted = paint(1, box({5, 5, -1}, {6, 6, 1}), cover(0, half_space({0, 0, 1}, 0)));
  const Scene scene = compile({{{"dry", {}, {}}, {"wet", {}, {}}}, painted});
  Neighbourhood near;
  ASSERT_TRUE(near.look_around(scene, {{0, 0, -1}, {2, 2, 2}}));
  EXPECT_EQ(near.cells().cells[0].material.material, 0u);
  ASSERT_TRUE(near.look_around(scene, {{0, 0, -1}, {5, 5, 2}}));
  EXPECT_EQ(near.cells().cells[0].material.material, CellMaterial::by_rules);
}

TEST(Neighbourhoods, AreNotKnownWhereTheyAreCrowdedOrOutOfReach) {
  const Scene town = compile(cases::town_of(100, 1));
  Neighbourhood near;
  EXPECT_FALSE(near.look_around(town, {{0, 0, -1}, {240, 240, 9}}));
  EXPECT_TRUE(near.cells().cells.empty());
  EXPECT_FALSE(near.look_around(town, {{0, 0, -1}, {1e30, 1, 1}}));
  EXPECT_TRUE(near.look_around(town, {{0, 0, -1}, {1, 1, 1}}));
}

}  // namespace
}  // namespace groundtruth::fast
