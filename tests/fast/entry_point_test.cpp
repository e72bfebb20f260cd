#include <groundtruth/fast/entry_point.hpp>

#include <gtest/gtest.h>
#include <groundtruth/tests/fast/shapes.hpp>

namespace groundtruth {
namespace {

constexpr std::nullopt_t no_material = std::nullopt;

EntryAnswer enter(const Shape& shape, const EntryAsk& ask) {
  return fast::entry_point(fast::compile(Scene{{}, shape}), ask);
}

EntryAnswer border(double lambda, Leaf leaf, Vector normal,
                   std::optional<MaterialIndex> material = no_material) {
  return Border{lambda, leaf, normal, material};
}

// Walls y = +-4 and x = +-3, floor z = 0, roof planes y + z = 6 and -y + z = 6.
Shape house() {
  return intersect({half_space({1, 0, 0}, 3), half_space({-1, 0, 0}, 3), half_space({0, 1, 0}, 4),
                    half_space({0, -1, 0}, 4), half_space({0, 0, -1}, 0), half_space({0, 1, 1}, 6),
                    half_space({0, -1, 1}, 6)});
}

TEST(FastHouse, IsEnteredThroughRoofWallAndFloor) {
  EXPECT_EQ(enter(house(), {{0, 1, 9}, {0, 1, 1}}), border(0.5, 5, {0, 1, 1}));
  EXPECT_EQ(enter(house(), {{7, 0, 1}, {-1, 0, 1}}), border(0.5, 0, {1, 0, 0}));
  EXPECT_EQ(enter(house(), {{0, 0, -1}, {0, 0, 3}}), border(0.25, 4, {0, 0, -1}));
}

TEST(FastHouse, IsMissedBesideAndBehindTheRange) {
  EXPECT_EQ(enter(house(), {{4, 0, 9}, {4, 0, -9}}), EntryAnswer(Miss{}));
  EXPECT_EQ(enter(house(), {{0, 0, 20}, {0, 0, 7}}), EntryAnswer(Miss{}));
  EXPECT_EQ(enter(house(), {{0, 0, 7}, {0, 0, 20}}), EntryAnswer(Miss{}));
}

TEST(FastHouse, IsEnteredAtItsRidgeThroughTheFirstRoofPlane) {
  EXPECT_EQ(enter(house(), {{0, 0, 8}, {0, 0, 4}}), border(0.5, 5, {0, 1, 1}));
}

TEST(FastHouse, StartedInIsInside) {
  EXPECT_EQ(enter(house(), {{0, 0, 1}, {0, 0, 9}}), EntryAnswer(Inside{0}));
}

TEST(FastHouse, StartedOnAFaceIsBorderEvenWhenLeaving) {
  EXPECT_EQ(enter(house(), {{3, 0, 1}, {9, 0, 1}}), border(0, 0, {1, 0, 0}));
}

TEST(FastRange, MovesTheStart) {
  const EntryAsk through{{0, 0, -6}, {0, 0, 6}, 0.75, 2};
  EXPECT_EQ(enter(house(), through), EntryAnswer(Inside{0.75}));
  const EntryAsk from_before{{7, 0, 1}, {6, 0, 1}, -1, 5};
  EXPECT_EQ(enter(house(), from_before), border(4, 0, {1, 0, 0}));
  const EntryAsk to_before{{7, 0, 1}, {6, 0, 1}, -9, 3.5};
  EXPECT_EQ(enter(house(), to_before), EntryAnswer(Miss{}));
}

TEST(FastRange, OfOnePointAtTheEndOfTheSegmentTouches) {
  const EntryAsk touch{{0, 0, 8}, {0, 0, 6}, 1, 1};
  EXPECT_EQ(enter(house(), touch), border(1, 5, {0, 1, 1}));
}

TEST(FastSegment, OfNoLengthAnswersForItsPoint) {
  EXPECT_EQ(enter(house(), {{0, 0, 1}, {0, 0, 1}, 0, 2}), EntryAnswer(Inside{0}));
  EXPECT_EQ(enter(house(), {{3, 0, 1}, {3, 0, 1}, 0.5, 2}), border(0.5, 0, {1, 0, 0}));
  EXPECT_EQ(enter(house(), {{5, 0, 1}, {5, 0, 1}}), EntryAnswer(Miss{}));
}

TEST(FastIntersection, OfOppositeHalfSpacesApartIsMissed) {
  const Shape gap = intersect({half_space({1, 0, 0}, 0), half_space({-1, 0, 0}, -1)});
  EXPECT_EQ(enter(gap, {{-1, 0, 0}, {2, 0, 0}}), EntryAnswer(Miss{}));
}

TEST(FastSheet, IsEnteredThroughTheFaceThatLooksBack) {
  const Shape sheet = intersect({half_space({-1, 0, 0}, -1), half_space({1, 0, 0}, 1)});
  EXPECT_EQ(enter(sheet, {{0, 0, 0}, {2, 0, 0}}), border(0.5, 0, {-1, 0, 0}));
  EXPECT_EQ(enter(sheet, {{2, 0, 0}, {0, 0, 0}}), border(0.5, 1, {1, 0, 0}));
  EXPECT_EQ(enter(sheet, {{1, 0, 0}, {1, 5, 0}}), border(0, 0, {-1, 0, 0}));
}

TEST(FastPoint, IsEnteredThroughTheFirstOfItsEnteredLeaves) {
  const Shape point = box({1, 1, 1}, {1, 1, 1});
  EXPECT_EQ(enter(point, {{2, 2, 2}, {0, 0, 0}}), border(0.5, 1, {1, 0, 0}));
  EXPECT_EQ(enter(point, {{2, 2, 2}, {0, 0, 1}}), EntryAnswer(Miss{}));
}

TEST(FastSeam, OfAbuttingBoxesIsNoFace) {
  const Shape boxes = unite({box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1})});
  EXPECT_EQ(enter(boxes, {{1, 0.5, 2}, {1, 0.5, 0}}), border(0.5, 5, {0, 0, 1})) << "above the seam";
  EXPECT_EQ(enter(boxes, {{1, 0.5, 0.5}, {2, 0.5, 0.5}}), EntryAnswer(Inside{0})) << "in the seam";
  EXPECT_EQ(enter(boxes, {{3, 0.5, 3}, {0, 0.5, 0}}), border(2.0 / 3, 5, {0, 0, 1}))
      << "slanting to the seam";
  EXPECT_EQ(enter(boxes, {{1, 0.5, 1}, {1, 0.5, 4}}), border(0, 5, {0, 0, 1}))
      << "started on top of the seam";
}

TEST(FastSeam, BesideItOnlyTheBoxThatIsThereCounts) {
  const Shape boxes = cover(0, unite({box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1})}));
  EXPECT_EQ(enter(boxes, {{1.5, 0.5, 2}, {1.5, 0.5, 0}}), border(0.5, 11, {0, 0, 1}, 0));
}

TEST(FastUnion, OfComplementsIsInteriorInTheirPlane) {
  const Shape all = unite({half_space({1, 0, 0}, 0), half_space({-1, 0, 0}, 0)});
  EXPECT_EQ(enter(all, {{0, 0, 0}, {1, 0, 0}}), EntryAnswer(Inside{0}));
}

TEST(FastUnion, CoveringACornerLeavesItNoFaceThoughItIsEnteredFirst) {
  const Shape covered = unite({box({0, 0, 0}, {1, 1, 1}), half_space({-1, -1, 0}, 0)});
  EXPECT_EQ(enter(covered, {{-1, 0, 0.5}, {1, 0, 0.5}}), border(0.5, 6, {-1, -1, 0}));
}

TEST(FastUnion, CoveringALeafLeavesNoFace) {
  const Shape covered = unite({half_space({1, 0, 0}, 0), half_space({1, 0, 0}, 1)});
  EXPECT_EQ(enter(covered, {{0, 0, 0}, {1, 0, 0}}), EntryAnswer(Inside{0}));
  EXPECT_EQ(enter(covered, {{2, 0, 0}, {0, 0, 0}}), border(0.5, 1, {1, 0, 0}));
}

TEST(FastZeroNormal, IsEverythingOrNothingAndKeepsItsNumber) {
  EXPECT_EQ(enter(half_space({0, 0, 0}, 0), {{0, 0, 0}, {1, 0, 0}}), EntryAnswer(Inside{0}));
  EXPECT_EQ(enter(half_space({0, 0, 0}, -1), {{0, 0, 0}, {1, 0, 0}}), EntryAnswer(Miss{}));
  const Shape half = intersect({half_space({0, 0, 0}, 0), half_space({1, 0, 0}, 1)});
  EXPECT_EQ(enter(half, {{2, 0, 0}, {0, 0, 0}}), border(0.5, 1, {1, 0, 0}));
  EXPECT_EQ(enter(half, {{1, 0, 0}, {1, 1, 0}}), border(0, 1, {1, 0, 0}));
}

TEST(FastEmptyOperators, AreNothingAndEverything) {
  const EntryAsk ask{{0, 0, 0}, {1, 0, 0}, -2, 1};
  EXPECT_EQ(enter(unite({}), ask), EntryAnswer(Miss{}));
  EXPECT_EQ(enter(intersect({}), ask), EntryAnswer(Inside{-2}));
  EXPECT_EQ(enter(intersect({unite({}), intersect({})}), ask), EntryAnswer(Miss{}));
}

TEST(FastNestedIntersection, GoesOnWhereItsOperandsDisagree) {
  const Shape slabs_x = unite({box({0, 0, 0}, {1, 9, 9}), box({4, 0, 0}, {6, 9, 9})});
  const Shape slabs_y = unite({box({2, 0, 0}, {3, 9, 9}), box({5, 0, 0}, {9, 9, 9})});
  EXPECT_EQ(enter(intersect({slabs_x, slabs_y}), {{-1, 1, 1}, {9, 1, 1}}), border(0.6, 18, {-1, 0, 0}));
}

TEST(FastMaterial, OfTheOutermostCoverOrPaintWins) {
  const Shape patch = box({0, 0, -1}, {1, 1, 1});
  const Shape ground = half_space({0, 0, 1}, 0);
  const EntryAsk on_patch{{0.5, 0.5, 1}, {0.5, 0.5, -1}}, beside{{2, 0.5, 1}, {2, 0.5, -1}};
  EXPECT_EQ(enter(paint(1, patch, cover(0, ground)), on_patch), border(0.5, 0, {0, 0, 1}, 1));
  EXPECT_EQ(enter(paint(1, patch, cover(0, ground)), beside), border(0.5, 0, {0, 0, 1}, 0));
  EXPECT_EQ(enter(cover(0, paint(1, patch, ground)), on_patch), border(0.5, 0, {0, 0, 1}, 0));
  EXPECT_EQ(enter(paint(1, patch, ground), beside), border(0.5, 0, {0, 0, 1}));
}

TEST(FastMaterial, OfAPaintIncludesTheBorderOfItsRegion) {
  const Shape painted = paint(1, box({0, 0, 0}, {1, 1, 1}), half_space({0, 0, 1}, 0));
  EXPECT_EQ(enter(painted, {{1, 0.5, 1}, {1, 0.5, -1}}), border(0.5, 0, {0, 0, 1}, 1));
}

TEST(FastMaterial, RegionsHoldNoLeaves) {
  const Shape scene = unite(
      {paint(1, box({0, 0, 0}, {1, 1, 1}), half_space({0, 0, 1}, 0)), cover(2, half_space({0, 0, 1}, 1))});
  EXPECT_EQ(enter(scene, {{0, 0, 2}, {0, 0, 0}}), border(0.5, 1, {0, 0, 1}, 2));
}

}  // namespace
}  // namespace groundtruth
