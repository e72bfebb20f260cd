#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include <groundtruth/cases/range_changes.hpp>
#include <groundtruth/cases/scene_changes.hpp>
#include <groundtruth/cases/shape_parts.hpp>
#include <groundtruth/cases/small_scenes.hpp>

namespace groundtruth::cases {
namespace {

TEST(SmallScenes, StaySmallAndVary) {
  std::set<std::size_t> sizes;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    Random random(seed);
    const std::size_t leaves = leaf_count(small_scene(random).shape);
    EXPECT_LE(leaves, 120u) << seed;
    sizes.insert(leaves);
  }
  EXPECT_GT(sizes.size(), 20u);
}

TEST(SceneChanges, AddFewLeavesAndMostlyChangeSomething) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    Random random(seed);
    const Scene scene = small_scene(random);
    const Scene other = changed(scene, random);
    EXPECT_LE(leaf_count(other.shape), leaf_count(scene.shape) + 8) << seed;
  }
}

TEST(RangeMoved, AsksAboutTheSameStretchOfTheLine) {
  const EntryAsk ask{{1, 2, 4}, {-3, 8, 0}, 0.25, 0.75};
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Random random(seed);
    const EntryAsk moved = with_range_moved(ask, random);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto at = [axis](const EntryAsk& any, double lambda) {
        return any.from[axis] + lambda * (any.to[axis] - any.from[axis]);
      };
      EXPECT_EQ(at(moved, moved.lambda_first), at(ask, ask.lambda_first)) << seed;
      EXPECT_EQ(at(moved, moved.lambda_last), at(ask, ask.lambda_last)) << seed;
    }
  }
}

}  // namespace
}  // namespace groundtruth::cases
