// Leaving out never changes an answer; what is left out is reported.

#include <algorithm>

#include <gtest/gtest.h>
#include <groundtruth/cases/ask_source.hpp>
#include <groundtruth/cases/builtin_scenes.hpp>
#include <groundtruth/cases/random.hpp>
#include <groundtruth/cases/scene_builders.hpp>
#include <groundtruth/fast/entry_point.hpp>
#include <groundtruth/tests/fast/shapes.hpp>

namespace groundtruth {
namespace {

using fast::Simplification;

std::vector<Scene> scenes() {
  std::vector<Scene> all;
  for (const char* name : {"house", "ramp", "degenerate", "nested", "far-town"})
    for (Scene& scene : cases::find_builtin_scene(name)->build()) all.push_back(std::move(scene));
  all.push_back(cases::runway_of(20));
  all.push_back(cases::hills_of(5));
  for (std::uint64_t seed = 0; seed < 40; ++seed) all.push_back(cases::random_nested(seed, 6, 4));
  return all;
}

std::vector<EntryAsk> asks_about(const Scene& scene, std::uint64_t seed, std::size_t count) {
  cases::AskSource source(scene, seed, {1, 0, 0});
  std::vector<EntryAsk> asks;
  for (std::size_t i = 0; i < count; ++i) asks.push_back(std::get<EntryAsk>(source.next().ask));
  return asks;
}

class FastSimplification : public testing::TestWithParam<std::size_t> {};

TEST_P(FastSimplification, ChangesNoAnswer) {
  const auto what = static_cast<Simplification>(GetParam());
  std::uint64_t seed = 1;
  for (const Scene& scene : scenes()) {
    const fast::Scene with = fast::compile(scene);
    const fast::Scene without = fast::compile(scene, fast::CompileOptions().leave_off(what));
    for (const EntryAsk& ask : asks_about(scene, ++seed, 150))
      ASSERT_EQ(fast::entry_point(with, ask), fast::entry_point(without, ask))
          << name_of(what) << ", scene " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Each, FastSimplification,
                         testing::Range<std::size_t>(0, fast::number_of_simplifications));

std::size_t left_out(const Shape& shape, Simplification what) {
  const fast::Scene scene =
      fast::compile(Scene{{{"dry", {}, std::nullopt}, {"wet", {}, std::nullopt}}, shape});
  std::size_t count = 0;
  for (const fast::LeftOut& one : scene.left_out())
    if (one.what == what) count += one.count;
  return count;
}

TEST(FastLeftOut, CountsConstants) {
  EXPECT_GT(left_out(unite({half_space({1, 0, 0}, 0), {Nothing{}}}), Simplification::constants), 0u);
  EXPECT_EQ(left_out(half_space({1, 0, 0}, 0), Simplification::constants), 0u);
}

TEST(FastLeftOut, CountsDuplicatesEmptyAndBuriedParts) {
  const Shape ground = half_space({0, 0, 1}, 0), house = box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(left_out(unite({house, ground, house}), Simplification::duplicates), 1u);
  EXPECT_EQ(left_out(unite({house, ground, box({0, 0, 1}, {1, 1, 0.5})}), Simplification::empty_cells), 1u);
  EXPECT_EQ(left_out(unite({house, ground, box({0, 0, -2}, {1, 1, -1})}), Simplification::buried_parts), 1u);
  EXPECT_EQ(left_out(unite({house, ground, box({0, 0, -2}, {1, 1, 0})}), Simplification::buried_parts), 0u);
}

TEST(FastLeftOut, CountsDuplicatesWhateverStoodBetweenTheirHalfSpacesAndWithEitherZero) {
  const Shape interrupted =
      intersect({half_space({1, 0, 0}, 1), half_space({0, 0, 0}, 1), half_space({0, 1, 0}, 2)});
  const Shape whole = intersect({half_space({1, -0.0, 0}, 1), half_space({0, 1, -0.0}, 2)});
  const Shape other = intersect({half_space({1, 0, 0}, 1), half_space({0, 1, 0}, 3)});
  EXPECT_EQ(left_out(unite({interrupted, other, whole, interrupted}), Simplification::duplicates), 2u);
}

TEST(FastLeftOut, CountsRedundantHalfSpacesOnlyIfTheCellStaysAwayFromThem) {
  const auto cut = [](double offset) {
    return intersect({box({0, 0, 0}, {1, 1, 1}), half_space({1, 1, 0}, offset)});
  };
  EXPECT_EQ(left_out(cut(2.5), Simplification::redundant_half_spaces), 1u);
  EXPECT_EQ(left_out(cut(2), Simplification::redundant_half_spaces), 0u);
}

TEST(FastLeftOut, CountsRulesUnderAMaterial) {
  const Shape ground = half_space({0, 0, 1}, 0);
  EXPECT_EQ(left_out(cover(0, cover(1, ground)), Simplification::hidden_rules), 1u);
  EXPECT_EQ(left_out(paint(0, ground, cover(1, ground)), Simplification::hidden_rules), 0u);
}

TEST(FastLeftOut, CountsCellsWhoseMaterialIsKnownBeforeTheyAreHit) {
  const Shape ground = half_space({0, 0, 1}, 0), house = box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(left_out(unite({cover(0, ground), house}), Simplification::known_materials), 2u);
  EXPECT_EQ(left_out(paint(0, box({0, 0, 0}, {1, 1, 1}), ground), Simplification::known_materials), 0u);
}

TEST(FastLeftOut, CountsPaintsThatDoNotReachACellAndTheNextFurtherOutDecides) {
  const Shape patch = box({2, 2, 0}, {3, 3, 1}), house = box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(left_out(paint(0, patch, house), Simplification::remote_paints), 1u);
  EXPECT_EQ(left_out(paint(0, box({1, 1, 1}, {2, 2, 2}), house), Simplification::remote_paints), 0u);
  const fast::Scene compiled =
      fast::compile({{{"dry", {}, {}}, {"wet", {}, {}}}, cover(1, paint(0, patch, house))});
  const auto answer = fast::entry_point(compiled, {{0.5, 0.5, 2}, {0.5, 0.5, 0}});
  EXPECT_EQ(std::get<Border>(answer).material, MaterialIndex{1});
  const fast::Scene painted =
      fast::compile({{{"dry", {}, {}}, {"wet", {}, {}}}, paint(1, house, paint(0, patch, house))});
  EXPECT_EQ(std::get<Border>(fast::entry_point(painted, {{0.5, 0.5, 2}, {0.5, 0.5, 0}})).material,
            MaterialIndex{1});
}

TEST(FastLeftOut, CountsHalfSpacesThatOnlyCellsHoldUnlessAPartIsNoCell) {
  const Shape house = box({0, 0, 0}, {1, 1, 1}), ground = half_space({0, 0, 1}, 0);
  EXPECT_EQ(left_out(unite({house, ground}), Simplification::written_solid), 7u);
  const Shape notched = intersect({house, unite({half_space({1, 0, 0}, 0.5), half_space({0, 1, 0}, 0.5)})});
  EXPECT_EQ(left_out(unite({notched, ground}), Simplification::written_solid), 0u);
}

TEST(FastLeftOut, NamesTheIndex) {
  const auto chosen = [](const Scene& scene, Simplification what) {
    const auto all = fast::compile(scene).left_out();
    return std::any_of(all.begin(), all.end(),
                       [&](const auto& one) { return one.what == what && one.count > 0; });
  };
  EXPECT_FALSE(chosen(cases::house(), Simplification::hierarchy));
  EXPECT_TRUE(chosen(cases::town_of(100, 1), Simplification::hierarchy));
  EXPECT_TRUE(chosen(cases::town_of(100, 1), Simplification::grid));
}

}  // namespace
}  // namespace groundtruth
