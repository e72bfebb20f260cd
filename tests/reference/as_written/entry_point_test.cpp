#include <groundtruth/as_written/entry_point.hpp>

#include <gtest/gtest.h>

#include <cmath>

#include "shapes.hpp"

namespace groundtruth::as_written {
namespace {

const Errata none{};

EntryAsk along_x(double from, double to) { return {{from, 0, 0}, {to, 0, 0}}; }

Shape at_most(double x) { return half_space({1, 0, 0}, x); }
Shape at_least(double x) { return half_space({-1, 0, 0}, -x); }

TEST(SinglePassIntersection, FindsAPointInAnEmptyIntersection) {
  const Scene scene = bare(intersection_of({at_most(0), at_least(1)}));
  EXPECT_EQ(entry_point(scene, along_x(-1, 2), {Erratum::single_pass_intersection}),
            EntryAnswer(Border{2.0 / 3, 1, {-1, 0, 0}, std::nullopt}));
  EXPECT_EQ(entry_point(scene, along_x(-1, 2), none), EntryAnswer(Miss{}));
}

TEST(SinglePassIntersection, LeavesIntersectionsOfUnionsToTheRestart) {
  const Scene scene = bare(intersection_of({union_of({at_most(0), at_least(4)}), at_least(1)}));
  const Border at_four{0.5, 1, {-1, 0, 0}, std::nullopt};
  EXPECT_EQ(entry_point(scene, along_x(0, 8), {Erratum::single_pass_intersection}), EntryAnswer(at_four));
  EXPECT_EQ(entry_point(scene, along_x(0, 8), none), EntryAnswer(at_four));
}

TEST(NormalByOrder, CallsAnInteriorPointBorderByTheOrderOfOperands) {
  const Scene face_first = bare(union_of({at_most(0), at_most(1)}));
  const Scene face_last = bare(union_of({at_most(1), at_most(0)}));
  const Errata by_order{Erratum::normal_by_order};
  EXPECT_EQ(entry_point(face_first, along_x(0, 2), by_order),
            EntryAnswer(Border{0, 0, {1, 0, 0}, std::nullopt}));
  EXPECT_EQ(entry_point(face_last, along_x(0, 2), by_order), EntryAnswer(Inside{0}));
  EXPECT_EQ(entry_point(face_first, along_x(0, 2), none), EntryAnswer(Inside{0}));
  EXPECT_EQ(entry_point(face_last, along_x(0, 2), none), EntryAnswer(Inside{0}));
}

TEST(NormalByOrder, SeesAGhostFaceInASeam) {
  const Scene abutting = bare(union_of({box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1})}));
  const EntryAsk from_seam{{1, 0.5, 0.5}, {3, 0.5, 0.5}};
  EXPECT_EQ(entry_point(abutting, from_seam, {Erratum::normal_by_order}),
            EntryAnswer(Border{0, 1, {1, 0, 0}, std::nullopt}));
  EXPECT_EQ(entry_point(abutting, from_seam, none), EntryAnswer(Inside{0}));
}

TEST(NormalByOrder, TakesTheSeamForTheFaceOfAnEdgeOfTheJoint) {
  // Both boxes are met at once, where their common top face crosses the seam.
  const Scene abutting = bare(union_of({box({1, 0, 0}, {2, 1, 1}), box({0, 0, 0}, {1, 1, 1})}));
  const EntryAsk onto_joint{{0, 0.5, 2}, {2, 0.5, 0}};
  EXPECT_EQ(entry_point(abutting, onto_joint, {Erratum::normal_by_order}),
            EntryAnswer(Border{0.5, 0, {-1, 0, 0}, std::nullopt}));
  EXPECT_EQ(entry_point(abutting, onto_joint, none), EntryAnswer(Border{0.5, 5, {0, 0, 1}, std::nullopt}));
}

TEST(MissIsPlus1000, ReadsAsAHitFromTwoToThe63On) {
  const Scene scene = bare({Nothing{}});
  const Errata plus_1000{Erratum::miss_is_plus_1000};
  const EntryAsk below{{1, 0, 0}, {2, 0, 0}, 0, std::ldexp(1, 62)};
  const EntryAsk beyond{{1, 0, 0}, {2, 0, 0}, 0, std::ldexp(1, 63)};
  EXPECT_EQ(entry_point(scene, below, plus_1000), EntryAnswer(Miss{}));
  EXPECT_EQ(entry_point(scene, beyond, plus_1000), EntryAnswer(Inside{std::ldexp(1, 63)}));
  EXPECT_EQ(entry_point(scene, beyond, none), EntryAnswer(Miss{}));
}

TEST(EntryPoint, SheetIsEnteredByTheFaceThatLooksAtTheSegment) {
  const Scene sheet = bare(intersection_of({at_most(1), at_least(1)}));
  EXPECT_EQ(entry_point(sheet, along_x(0, 4), none), EntryAnswer(Border{0.25, 1, {-1, 0, 0}, std::nullopt}));
  EXPECT_EQ(entry_point(sheet, along_x(4, 0), none), EntryAnswer(Border{0.75, 0, {1, 0, 0}, std::nullopt}));
}

TEST(EntryPoint, SheetsRimIsEnteredByAnEnteredFaceAlthoughNoneBounds) {
  const Scene edge =
      bare(intersection_of({at_most(0), at_least(0), half_space({0, 1, 0}, 0), half_space({0, -1, 0}, 0)}));
  const EntryAsk across{{-1, -1, 0}, {1, 1, 0}};
  EXPECT_EQ(entry_point(edge, across, none), EntryAnswer(Border{0.5, 1, {-1, 0, 0}, std::nullopt}));
  const EntryAsk from_the_edge{{0, 0, 0}, {1, 1, 0}};
  EXPECT_EQ(entry_point(edge, from_the_edge, none), EntryAnswer(Border{0, 0, {1, 0, 0}, std::nullopt}));
}

TEST(EntryPoint, CrossingAtOneThirdIsOneParameterForAllPlanesThroughThePoint) {
  // The segment touches the box in an edge, at a point that no double is.
  const Scene scene = bare(box({1, 1, -1}, {2, 2, 1}));
  const EntryAsk past_edge{{0, 3, 0}, {3, 0, 0}};
  EXPECT_EQ(entry_point(scene, past_edge, none), EntryAnswer(Border{1.0 / 3, 0, {-1, 0, 0}, std::nullopt}));
}

TEST(EntryPoint, ZeroNormalIsEverythingOrNothingAndKeepsItsLeafNumber) {
  const Scene scene =
      bare(intersection_of({half_space({0, 0, 0}, 0), union_of({half_space({0, 0, 0}, -1), at_least(1)})}));
  EXPECT_EQ(entry_point(scene, along_x(0, 2), none), EntryAnswer(Border{0.5, 2, {-1, 0, 0}, std::nullopt}));
}

TEST(EntryPoint, OutermostPaintThatHoldsAtThePointGivesTheMaterial) {
  enum : MaterialIndex { ground, puddle, never };
  const Scene scene{{{{"ground", {}, {}}, {"puddle", {}, {}}, {"never", {}, {}}},
                     painted(puddle, at_least(1),
                             covered(ground, painted(never, {Everything{}}, half_space({0, 0, 1}, 0))))}};
  const auto material_at = [&](double x) {
    return std::get<Border>(entry_point(scene, {{x, 0, 1}, {x, 0, -1}}, none)).material;
  };
  EXPECT_EQ(material_at(0), ground);
  EXPECT_EQ(material_at(1), puddle);
  EXPECT_EQ(material_at(2), puddle);
}

// The half-space x >= `levels`, behind so many levels each of which finds a sliver before its own wall, and
// so asks the level below it twice.
Shape doubling(int levels) {
  Shape shape = at_least(levels);
  for (int level = 1; level < levels; ++level) {
    const double wall = levels - level;
    const double sliver = wall - 0.75;
    shape = intersection_of(
        {union_of({std::move(shape), intersection_of({at_least(sliver), at_most(sliver)})}), at_least(wall)});
  }
  return shape;
}

TEST(EntryPoint, RestartsMultiplyWithTheNestingYetEnd) {
  const Border behind_all{0.125, 0, {-1, 0, 0}, std::nullopt};
  EXPECT_EQ(entry_point(bare(doubling(8)), along_x(0, 64), none), EntryAnswer(behind_all));
  EXPECT_FALSE(std::holds_alternative<Inside>(entry_point(bare(doubling(40)), along_x(0, 64), none)));
}

}  // namespace
}  // namespace groundtruth::as_written
