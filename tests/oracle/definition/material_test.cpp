#include <gtest/gtest.h>

#include <groundtruth/definition/entry_point.hpp>

#include "shapes.hpp"

namespace groundtruth::definition {
namespace {

using namespace test;

const Shape ground = half_space(0, 0, 1, 0);
const Shape right = half_space(-1, 0, 0, 0);  // x >= 0

std::optional<MaterialIndex> material_at_x(const Shape& shape, double x) {
  return std::get<Border>(entry_point(Scene(scene_of(shape)), {{x, 0, 1}, {x, 0, -1}}).answer).material;
}

TEST(Material, IsNoneWhereNoneIsSaid) { EXPECT_EQ(material_at_x(ground, 0), std::nullopt); }

TEST(Material, IsTheOutermost) {
  EXPECT_EQ(material_at_x(made_of(1, made_of(2, ground)), 0), 1u);
  EXPECT_EQ(material_at_x(any_of({made_of(1, any_of({made_of(2, ground)}))}), 0), 1u);
}

TEST(Material, OfPaintHoldsInItsClosedRegionOnly) {
  const Shape shape = painted(1, right, made_of(2, ground));
  EXPECT_EQ(material_at_x(shape, 1), 1u);
  EXPECT_EQ(material_at_x(shape, 0), 1u);
  EXPECT_EQ(material_at_x(shape, -0x1p-1074), 2u);
}

TEST(Material, OfPaintUnderACoverIsHidden) {
  EXPECT_EQ(material_at_x(made_of(2, painted(1, right, ground)), 1), 2u);
}

TEST(Material, OfTheOuterOfTwoPaintsThatHold) {
  const Shape left = half_space(1, 0, 0, 1);
  const Shape shape = painted(1, right, painted(2, left, ground));
  EXPECT_EQ(material_at_x(shape, 2), 1u);
  EXPECT_EQ(material_at_x(shape, 0.5), 1u);
  EXPECT_EQ(material_at_x(shape, -1), 2u);
}

TEST(Material, OfPaintAsksItsRegionForMembershipThroughMaterialsAndPaints) {
  const Shape region = painted(3, {Nothing{}}, made_of(4, right));
  EXPECT_EQ(material_at_x(painted(1, region, ground), 1), 1u);
  EXPECT_EQ(material_at_x(painted(1, region, ground), -1), std::nullopt);
}

TEST(Material, CountsNoLeavesInARegion) {
  const Shape shape = any_of({painted(1, box({0, 0, 0}, {1, 1, 1}), ground), half_space(0, 0, 1, -5)});
  const EntryFinding finding = entry_point(Scene(scene_of(shape)), {{5, 5, 1}, {5, 5, -1}});
  EXPECT_EQ(std::get<Border>(finding.answer).leaf, 0u);
  EXPECT_EQ(std::get<Border>(finding.answer).material, std::nullopt);
}

TEST(Material, IsThatOfTheBoxBelowNotOfItsNeighbour) {
  const Shape boxes = any_of({made_of(1, box({0, 0, 0}, {1, 1, 1})), made_of(2, box({1, 0, 0}, {2, 1, 1}))});
  EXPECT_EQ(material_at_x(boxes, 0.5), 1u);
  EXPECT_EQ(material_at_x(boxes, 1.5), 2u);
  EXPECT_EQ(material_at_x(boxes, 1), 1u);
}

}  // namespace
}  // namespace groundtruth::definition
