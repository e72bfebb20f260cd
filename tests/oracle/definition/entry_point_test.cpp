#include <gtest/gtest.h>

#include <groundtruth/definition/entry_point.hpp>

#include "shapes.hpp"

namespace groundtruth::definition {
namespace {

using namespace test;
using Leaves = std::vector<Leaf>;

EntryFinding ask(const Shape& shape, const Vector& from, const Vector& to, double first = 0,
                 double last = 1) {
  return entry_point(Scene(scene_of(shape)), {from, to, first, last});
}

// On a border: where, on which leaves. Of all else: empty.
struct Hit {
  std::string lambda;
  Leaves admissible;
  bool operator==(const Hit&) const = default;
  friend std::ostream& operator<<(std::ostream& out, const Hit& hit) {
    out << "lambda " << hit.lambda << ", leaves";
    for (const Leaf leaf : hit.admissible) out << ' ' << leaf;
    return out;
  }
};

Hit border(const EntryFinding& finding) {
  const auto* found = std::get_if<Border>(&finding.answer);
  if (!found) return {};
  EXPECT_EQ(found->leaf, finding.evidence.admissible.front());
  return {finding.evidence.lambda_exact, finding.evidence.admissible};
}

bool is_miss(const EntryFinding& finding) { return std::holds_alternative<Miss>(finding.answer); }

std::string inside_at(const EntryFinding& finding) {
  return std::holds_alternative<Inside>(finding.answer) ? finding.evidence.lambda_exact : "not inside";
}

const Shape ground = half_space(0, 0, 1, 0);

TEST(EntryPoint, IsCorrectlyRounded) {
  const EntryFinding finding = ask(ground, {0, 0, 1}, {0, 0, -2});
  EXPECT_EQ(border(finding), (Hit{"1/3", {0}}));
  EXPECT_EQ(std::get<Border>(finding.answer).lambda, 1.0 / 3.0);
}

TEST(EntryPoint, MayLieAtEitherEndOfTheRange) {
  EXPECT_EQ(border(ask(ground, {0, 0, 1}, {0, 0, 0})), (Hit{"1", {0}}));
  EXPECT_TRUE(is_miss(ask(ground, {0, 0, 1}, {0, 0, 0x1p-1074})));
  EXPECT_EQ(border(ask(ground, {0, 0, 0}, {0, 0, 1})), (Hit{"0", {0}}));
  EXPECT_EQ(inside_at(ask(ground, {0, 0, -0x1p-1074}, {0, 0, 1})), "0");
}

TEST(EntryPoint, OfARangeBeyondTheEndsOfTheSegment) {
  EXPECT_EQ(border(ask(ground, {0, 0, 1}, {0, 0, 2}, -2, -0.5)), Hit{});
  EXPECT_EQ(inside_at(ask(ground, {0, 0, 1}, {0, 0, 2}, -2, -0.5)), "-2");
  EXPECT_EQ(border(ask(ground, {0, 0, 2}, {0, 0, 1}, -1, 4)), (Hit{"2", {0}}));
  EXPECT_TRUE(is_miss(ask(ground, {0, 0, 2}, {0, 0, 1}, -1, 1.5)));
}

TEST(EntryPoint, OfASegmentThatIsAPoint) {
  const Shape cube = box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(inside_at(ask(cube, {0.5, 0.5, 0.5}, {0.5, 0.5, 0.5})), "0");
  EXPECT_EQ(border(ask(cube, {1, 0.5, 0.5}, {1, 0.5, 0.5})), (Hit{"0", {1}}));
  EXPECT_TRUE(is_miss(ask(cube, {2, 0.5, 0.5}, {2, 0.5, 0.5})));
  EXPECT_EQ(border(ask(cube, {2, 0.5, 0.5}, {0, 0.5, 0.5}, 0.5, 0.5)), (Hit{"1/2", {1}}));
}

TEST(EntryPoint, NeedsNoConvexSolid) {
  // Enters the first slab's planes and leaves them again before it comes to the second slab.
  const Shape slabs =
      any_of({all_of({half_space(-1, 0, 0, -1), half_space(1, 0, 0, 2), half_space(0, 1, 0, -9)}),
              all_of({half_space(-1, 0, 0, -3), half_space(1, 0, 0, 4)})});
  EXPECT_EQ(border(ask(slabs, {0, 0, 0}, {8, 0, 0})), (Hit{"3/8", {3}}));
}

TEST(EntryPoint, OfDisjointHalfSpacesIsAMiss) {
  const Shape gap = all_of({half_space(1, 0, 0, 0), half_space(-1, 0, 0, -1)});
  EXPECT_TRUE(is_miss(ask(gap, {-1, 0, 0}, {2, 0, 0})));
}

TEST(EntryPoint, OfASheetIsTheSideThatIsEntered) {
  const Shape sheet = all_of({half_space(0, 0, 1, 0), half_space(0, 0, -1, 0)});
  EXPECT_EQ(border(ask(sheet, {0, 0, 1}, {0, 0, -1})), (Hit{"1/2", {0}}));
  EXPECT_EQ(border(ask(sheet, {0, 0, -1}, {0, 0, 1})), (Hit{"1/2", {1}}));
  EXPECT_EQ(border(ask(sheet, {0, 0, 0}, {1, 0, 0})), (Hit{"0", {0, 1}}));
}

TEST(EntryPoint, OfAnEdgeThinnerThanAFaceTakesTheEnteredLeavesThatStand) {
  // The x axis, as two crossing sheets.
  const Shape line = all_of(
      {half_space(0, 0, 1, 0), half_space(0, 0, -1, 0), half_space(0, 1, 0, 0), half_space(0, -1, 0, 0)});
  EXPECT_EQ(border(ask(line, {0, 0, 2}, {0, 0, -2})), (Hit{"1/2", {0}}));
  EXPECT_EQ(border(ask(line, {0, -2, 2}, {0, 2, -2})), (Hit{"1/2", {0, 3}}));
  EXPECT_EQ(border(ask(line, {0, 0, 0}, {1, 0, 0})), (Hit{"0", {0, 1, 2, 3}}));
}

TEST(EntryPoint, OfASinglePoint) {
  const Shape point = box({1, 1, 1}, {1, 1, 1});
  EXPECT_EQ(border(ask(point, {0, 0, 0}, {3, 3, 3})), (Hit{"1/3", {0, 2, 4}}));
  EXPECT_EQ(border(ask(point, {1, 1, 1}, {3, 3, 3})), (Hit{"0", {0, 1, 2, 3, 4, 5}}));
  EXPECT_TRUE(is_miss(ask(point, {0, 0, 0}, {3, 3, 2.9999999999999996})));
}

TEST(EntryPoint, OfTheRimOfASheetTakesTheRimToo) {
  const Shape sheet = all_of({half_space(0, 0, 1, 0), half_space(0, 0, -1, 0), half_space(1, 0, 0, 0)});
  // Along the sheet no face of it is entered; all that is left is the rim.
  EXPECT_EQ(border(ask(sheet, {1, 0, 0}, {-1, 0, 0})), (Hit{"1/2", {2}}));
  // Onto the rim from above the sheet bounds, the rim does not: the sheet has no inside to it.
  EXPECT_EQ(border(ask(sheet, {1, 0, 1}, {-1, 0, -1})), (Hit{"1/2", {0}}));
}

TEST(EntryPoint, OfASegmentInAFacePlaneIsTheEdgeThatIsMet) {
  const Shape cube = box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(border(ask(cube, {-1, 0.5, 1}, {1, 0.5, 1})), (Hit{"1/2", {0}}));
  EXPECT_EQ(border(ask(cube, {-1, 1, 1}, {1, 1, 1})), (Hit{"1/2", {0}}));
  EXPECT_TRUE(is_miss(ask(cube, {-1, 2, 1}, {1, 2, 1})));
}

TEST(EntryPoint, OfACornerMayBeAnyEnteredFaceThere) {
  const Shape cube = box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(border(ask(cube, {2, 2, 2}, {0, 0, 0})), (Hit{"1/2", {1, 3, 5}}));
  EXPECT_EQ(border(ask(cube, {2, 0.5, 2}, {0, 0.5, 0})), (Hit{"1/2", {1, 5}}));
  EXPECT_EQ(border(ask(cube, {2, 0, 2}, {0, 2, 0})), (Hit{"1/2", {1, 5}}));
  EXPECT_EQ(border(ask(cube, {1, 1, 1}, {2, 2, 2})), (Hit{"0", {1, 3, 5}}));
}

TEST(EntryPoint, OfTheSeamOfAbuttingBoxesIsNoGhostFace) {
  const Shape boxes = any_of({box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1})});
  EXPECT_EQ(border(ask(boxes, {1, 0.5, 2}, {1, 0.5, 0})), (Hit{"1/2", {5, 11}}));
  EXPECT_EQ(border(ask(boxes, {0.5, 0.5, 1.5}, {1.5, 0.5, 0.5})), (Hit{"1/2", {5, 11}}));
  EXPECT_EQ(inside_at(ask(boxes, {1, 0.5, 0.5}, {1, 0.5, 2})), "0");
  EXPECT_EQ(border(ask(boxes, {1, 0.5, 1}, {1, 0.5, 2})), (Hit{"0", {5, 11}}));
}

TEST(EntryPoint, OfTwoBoxesWithOneTopPlaneIsTheTopOfTheOneBelow) {
  const Shape boxes = any_of({box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1})});
  EXPECT_EQ(border(ask(boxes, {0.5, 0.5, 2}, {0.5, 0.5, 0})), (Hit{"1/2", {5}}));
  EXPECT_EQ(border(ask(boxes, {1.5, 0.5, 2}, {1.5, 0.5, 0})), (Hit{"1/2", {11}}));
}

TEST(EntryPoint, InACavityTakesFacesThatNoNearbySegmentReaches) {
  // Beside the pit x > 0, y > 0, z < 0 its wall x = 0 is entered, but only from within the pit.
  const Shape pit =
      any_of({all_of({half_space(0, 1, 0, 0), half_space(0, 0, 1, 0)}),
              all_of({half_space(0, -1, 0, 0), half_space(0, 0, -1, 0)}),
              all_of({half_space(1, 0, 0, 0), half_space(0, -1, 0, 0), half_space(0, 0, 1, 0)})});
  EXPECT_EQ(border(ask(pit, {1, -1, 1}, {-1, 1, -1})), (Hit{"1/2", {1, 2, 4}}));
}

TEST(EntryPoint, OfTwoFacesInOnePlaneIsEither) {
  const Shape twice = any_of({half_space(0, 0, 1, 0), half_space(0, 0, 2, 0)});
  EXPECT_EQ(border(ask(twice, {0, 0, 1}, {0, 0, -1})), (Hit{"1/2", {0, 1}}));
}

TEST(EntryPoint, OfHalvesThatMakeAllOfSpaceIsInside) {
  const Shape halves = any_of({half_space(1, 0, 0, 0), half_space(-1, 0, 0, 0)});
  EXPECT_EQ(inside_at(ask(halves, {0, 0, 0}, {1, 0, 0})), "0");
  const Shape nested = any_of({half_space(1, 0, 0, 0), half_space(1, 0, 0, 1)});
  EXPECT_EQ(inside_at(ask(nested, {0, 0, 0}, {1, 0, 0})), "0");
}

TEST(EntryPoint, KnowsQuartersThatMeetInALineFromAllOfSpace) {
  const auto quarter = [](double x, double y) {
    return all_of({half_space(x, 0, 0, 0), half_space(0, y, 0, 0)});
  };
  const Shape three = any_of({quarter(1, 1), quarter(1, -1), quarter(-1, 1)});
  EXPECT_EQ(border(ask(three, {0, 0, 0}, {1, 1, 0})), (Hit{"0", {2, 5}}));
  const Shape four = any_of({quarter(1, 1), quarter(1, -1), quarter(-1, 1), quarter(-1, -1)});
  EXPECT_EQ(inside_at(ask(four, {0, 0, 0}, {1, 1, 0})), "0");
}

TEST(EntryPoint, OfAHalfSpaceWithoutNormalIsEverythingOrNothing) {
  EXPECT_EQ(inside_at(ask(half_space(0, 0, 0, 0), {1, 2, 3}, {4, 5, 6})), "0");
  EXPECT_EQ(inside_at(ask(half_space(0, 0, 0, 1), {1, 2, 3}, {4, 5, 6}, 0.25)), "1/4");
  EXPECT_TRUE(is_miss(ask(half_space(0, 0, 0, -1), {1, 2, 3}, {4, 5, 6})));
}

TEST(EntryPoint, CountsAHalfSpaceWithoutNormalAsALeafThatNeverStands) {
  const Shape both = all_of({half_space(0, 0, 0, 0), half_space(0, 0, 1, 0)});
  EXPECT_EQ(border(ask(both, {0, 0, 1}, {0, 0, -1})), (Hit{"1/2", {1}}));
  EXPECT_EQ(border(ask(both, {0, 0, 0}, {0, 0, 1})), (Hit{"0", {1}}));
}

TEST(EntryPoint, OfEmptyCombinationsIsTheirConvention) {
  EXPECT_TRUE(is_miss(ask(any_of({}), {0, 0, 1}, {0, 0, -1})));
  EXPECT_EQ(inside_at(ask(all_of({}), {0, 0, 1}, {0, 0, -1})), "0");
  EXPECT_TRUE(is_miss(ask({Nothing{}}, {0, 0, 1}, {0, 0, -1})));
  EXPECT_EQ(inside_at(ask({Everything{}}, {0, 0, 1}, {0, 0, -1})), "0");
  EXPECT_EQ(border(ask(any_of({any_of({}), all_of({ground, all_of({})})}), {0, 0, 1}, {0, 0, -1})),
            (Hit{"1/2", {0}}));
}

TEST(EntryPoint, SeesNoFaceUnderWhatSwallowsIt) {
  EXPECT_EQ(inside_at(ask(any_of({ground, {Everything{}}}), {0, 0, 0}, {0, 0, 1})), "0");
  // Leaf 1 lies in the plane that is hit, but what it bounds is nothing.
  const Shape shape = any_of({ground, all_of({half_space(0, 0, 1, 0), {Nothing{}}})});
  EXPECT_EQ(border(ask(shape, {0, 0, 1}, {0, 0, -1})), (Hit{"1/2", {0}}));
}

TEST(EntryPoint, ReportsTheNormalAsWritten) {
  const EntryFinding finding = ask(half_space(0.1, 0, 3, 0), {0, 0, 1}, {0, 0, -1});
  EXPECT_EQ(std::get<Border>(finding.answer).normal_in_world, (Vector{0.1, 0, 3}));
}

}  // namespace
}  // namespace groundtruth::definition
