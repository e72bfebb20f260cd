// Which stage decides: each is forced, and the answer is the right one whichever it was.

#include <groundtruth/fast/decided_entry.hpp>

#include <gtest/gtest.h>
#include <groundtruth/tests/fast/shapes.hpp>

namespace groundtruth {
namespace {

using fast::Stage;

fast::DecidedEntry decide(const Shape& shape, const EntryAsk& ask) {
  return fast::decide_entry(fast::compile(Scene{{{"dry", {}, std::nullopt}}, shape}), ask);
}

TEST(FastStages, DoublesDecideAMissByAMargin) {
  const auto decided = decide(box({0, 0, 0}, {1, 1, 1}), {{2, 0, 5}, {2.5, 0, -5}});
  EXPECT_EQ(decided.answer, EntryAnswer(Miss{}));
  EXPECT_EQ(decided.place, Stage::doubles);
}

TEST(FastStages, DoublesDecideAFaceByAMarginAndADoublePairRoundsLambda) {
  const auto decided = decide(cover(0, box({0, 0, 0}, {1, 1, 1})), {{0.3, 0.4, 4}, {0.3, 0.4, -3}});
  EXPECT_EQ(decided.answer, EntryAnswer(Border{3.0 / 7, 5, {0, 0, 1}, 0}));
  EXPECT_EQ(decided.place, Stage::doubles);
  EXPECT_EQ(decided.lambda, Stage::double_pair);
  EXPECT_EQ(decided.material, Stage::doubles);
}

TEST(FastStages, DoublesDecideAnInterior) {
  const auto decided = decide(box({0, 0, 0}, {1, 1, 1}), {{0.5, 0.5, 0.5}, {9, 9, 9}, 0, 0.5});
  EXPECT_EQ(decided.answer, EntryAnswer(Inside{0}));
  EXPECT_EQ(decided.place, Stage::doubles);
}

TEST(FastStages, ExactNumbersDecideAnEdge) {
  const auto decided = decide(box({0, 0, 0}, {1, 1, 1}), {{2, 0.5, 2}, {0, 0.5, 0}});
  EXPECT_EQ(decided.answer, EntryAnswer(Border{0.5, 1, {1, 0, 0}, std::nullopt}));
  EXPECT_EQ(decided.place, Stage::exact);
}

TEST(FastStages, ExactNumbersDecideASeam) {
  const auto decided =
      decide(unite({box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1})}), {{1, 0.5, 2}, {1, 0.5, 0}});
  EXPECT_EQ(decided.answer, EntryAnswer(Border{0.5, 5, {0, 0, 1}, std::nullopt}));
  EXPECT_EQ(decided.place, Stage::exact);
}

TEST(FastStages, ExactNumbersDecideAMissByTheSmallestDistance) {
  const double above = 0x1.0000000000001p0;
  const auto misses = decide(box({0, 0, 0}, {1, 1, 1}), {{0.5, -1, above}, {0.5, 2, above}});
  EXPECT_EQ(misses.answer, EntryAnswer(Miss{}));
  EXPECT_EQ(misses.place, Stage::exact);
  const auto hits = decide(box({0, 0, 0}, {1, 1, 1}), {{0.5, -1, 1}, {0.5, 2, 1}});
  EXPECT_EQ(hits.answer, EntryAnswer(Border{1.0 / 3, 2, {0, -1, 0}, std::nullopt}));
  EXPECT_EQ(hits.place, Stage::exact);
}

TEST(FastStages, ExactNumbersDecideWhereDoublesOverflowOrUnderflow) {
  for (const double length : {0x1p1020, 0x1p-1060}) {
    const auto decided = decide(half_space({0, 0, 1}, length), {{0, 0, 3 * length}, {0, 0, -5 * length}});
    EXPECT_EQ(decided.answer, EntryAnswer(Border{0.25, 0, {0, 0, 1}, std::nullopt})) << length;
    EXPECT_EQ(decided.place, Stage::exact) << length;
  }
}

// lambda = 1/2 + 2^-54 exactly: halfway between two doubles, which no approximation can tell from beside it.
TEST(FastStages, ExactNumbersRoundALambdaHalfwayBetweenDoubles) {
  const double down = -(0x1p53 - 1);
  const auto even = decide(half_space({0, 0, 1}, 0), {{0, 0, 0x1p53 + 1 - 1}, {0, 0, down}});
  EXPECT_EQ(even.place, Stage::doubles);
  const auto tie = decide(half_space({0, 0, 0x1p-52}, 0), {{0, 0, 0x1p53}, {0, 0, 0x1p53 - 0x1p54}});
  EXPECT_EQ(std::get<Border>(tie.answer).lambda, 0.5);
  const auto halfway =
      decide(half_space({1, 1, 0}, 0), {{0x1p53, 1, 0}, {-0x1p53, 1, 0}});  // (2^53 + 1) / 2^54
  EXPECT_EQ(std::get<Border>(halfway.answer).lambda, 0.5);
  EXPECT_EQ(halfway.place, Stage::doubles);
  EXPECT_EQ(halfway.lambda, Stage::exact);
  const auto odd = decide(half_space({1, 1, 0}, 0), {{0x1p53, 3, 0}, {-0x1p53, 3, 0}});  // (2^53 + 3) / 2^54
  EXPECT_EQ(std::get<Border>(odd.answer).lambda, 0.5 + 0x2p-53);
  EXPECT_EQ(odd.lambda, Stage::exact);
}

TEST(FastStages, ExactNumbersDecideTheRimOfAPaintButNotItsOwnPlane) {
  const Shape in_plane = paint(0, box({0, 0, -1}, {1, 1, 0}), half_space({0, 0, 1}, 0));
  const auto inside = decide(in_plane, {{0.5, 0.5, 1}, {0.5, 0.5, -1}});
  EXPECT_EQ(inside.answer, EntryAnswer(Border{0.5, 0, {0, 0, 1}, 0}));
  EXPECT_EQ(inside.material, Stage::doubles);
  const auto rim = decide(in_plane, {{1, 0.5, 1}, {1, 0.5, -1}});
  EXPECT_EQ(rim.answer, EntryAnswer(Border{0.5, 0, {0, 0, 1}, 0}));
  EXPECT_EQ(rim.material, Stage::exact);
}

TEST(FastStages, DoublesSufficeOnRangesOtherThanTheWhole) {
  const auto decided = decide(half_space({0, 0, 1}, 0), {{0, 0, 3}, {0, 0, 2}, 1.5, 77});
  EXPECT_EQ(decided.answer, EntryAnswer(Border{3, 0, {0, 0, 1}, std::nullopt}));
  EXPECT_EQ(decided.place, Stage::doubles);
}

}  // namespace
}  // namespace groundtruth
