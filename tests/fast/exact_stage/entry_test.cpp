#include <groundtruth/fast/exact_stage/entry.hpp>

#include <random>

#include <gtest/gtest.h>
#include <groundtruth/fast/scene.hpp>
#include <groundtruth/tests/fast/shapes.hpp>
#include <groundtruth/tests/fast/with_solid.hpp>

namespace groundtruth::fast::exact_stage {
namespace {

ExpressionView view_of(const fast::Scene& scene) { return {scene.solid().nodes, scene.solid().leaves, {}}; }

struct Entry {
  double lambda;
  std::optional<std::size_t> leaf;
  std::size_t words;
  bool operator==(const Entry& other) const { return lambda == other.lambda && leaf == other.leaf; }
};

std::optional<Entry> entry_of(const fast::Scene& scene, const EntryAsk& ask) {
  const auto point = first_point(view_of(scene), ask);
  if (!point) return std::nullopt;
  const double lambda =
      point->crossed ? crossing(scene.solid().leaves[*point->crossed], ask) : ask.lambda_first;
  return Entry{lambda, point->leaf, point->words};
}

std::optional<Entry> entry_of(const Shape& shape, const EntryAsk& ask) {
  return entry_of(compile_with_solid(groundtruth::Scene{{}, shape}), ask);
}

void expect_border(const std::optional<Entry>& got, double lambda, std::size_t leaf) {
  ASSERT_TRUE(got);
  EXPECT_EQ(got->lambda, lambda);
  EXPECT_EQ(got->leaf, leaf);
}

TEST(FastExactEntry, AnswersSubnormalAndLargestCoordinates) {
  expect_border(entry_of(half_space({1, 0, 0}, 0x1p-1074), {{0x3p-1074, 0, 0}, {-0x1p-1074, 0, 0}}), 0.5, 0);
  const double largest = 0x1.fffffffffffffp1023;
  expect_border(entry_of(half_space({largest, largest, largest}, -largest),
                         {{largest, largest, largest}, {-largest, -largest, -largest}}),
                0.5, 0);
  expect_border(entry_of(half_space({0x1p-1074, 0, 0}, 0x1p-1074), {{3, 0, 0}, {-1, 0, 0}}), 0.5, 0);
}

TEST(FastExactEntry, SeesWhatNoDoubleSees) {
  // 0.1 + 0.2 > 0.3 in exact doubles: by 2^-54 or so.
  const HalfSpace plane{{1, 1, 0}, 0.3};
  EXPECT_FALSE(entry_of(half_space(plane.normal, plane.offset), {{1, 0.2, 0}, {0.1, 0.2, 0}}));
  EXPECT_TRUE(
      entry_of(half_space(plane.normal, std::nextafter(plane.offset, 1)), {{1, 0.2, 0}, {0.1, 0.2, 0}}));
}

TEST(FastExactEntry, TheSeamOfAbuttingBoxesIsNoFace) {
  const Shape boxes = unite({box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1})});
  expect_border(entry_of(boxes, {{1, 0.5, 2}, {1, 0.5, 0}}), 0.5, 5);
  expect_border(entry_of(boxes, {{1.5, 0.5, 2}, {1.5, 0.5, 0}}), 0.5, 11);
  const auto inside = entry_of(boxes, {{1, 0.5, 0.5}, {3, 0.5, 0.5}});
  ASSERT_TRUE(inside);
  EXPECT_EQ(inside->leaf, std::nullopt);
}

TEST(FastExactEntry, NumbersOfLeavesDecideWhichIsCanonical) {
  const Shape edge = intersect({half_space({1, 0, 0}, 0), half_space({0, 1, 0}, 0)});
  const fast::Scene scene = compile_with_solid(groundtruth::Scene{{}, edge});
  const EntryAsk onto_edge{{1, 1, 0}, {-1, -1, 0}};
  ExpressionView view = view_of(scene);
  EXPECT_EQ(first_point(view, onto_edge)->leaf, 0u);
  const Leaf numbers[] = {7, 3};
  view.numbers = numbers;
  EXPECT_EQ(first_point(view, onto_edge)->leaf, 1u);
}

TEST(FastExactEntry, RangesStartAnywhere) {
  const Shape slab = box({0, -1, -1}, {1, 1, 1});
  const EntryAsk ask{{-1, 0, 0}, {0, 0, 0}, -0.5, 3};
  expect_border(entry_of(slab, ask), 1, 0);
  EXPECT_FALSE(entry_of(slab, {{-1, 0, 0}, {0, 0, 0}, 2.125, 3}));
  expect_border(entry_of(slab, {{-1, 0, 0}, {0, 0, 0}, 2, 2}), 2, 1);
}

TEST(FastExactEntry, MembershipIsAskedAtTheCrossingItself) {
  const fast::Scene region = compile_with_solid(groundtruth::Scene{{}, half_space({0, 1, 0}, 1.0 / 3)});
  // At x = 0 the segment's y is 1/3 of a double that is no third.
  const EntryAsk ask{{2, 1, 0}, {-1, 0, 0}};
  const HalfSpace face{{1, 0, 0}, 0};
  EXPECT_FALSE(contains(view_of(region), ask, face)) << "the double 1/3 is less than 1/3";
  const fast::Scene more =
      compile_with_solid(groundtruth::Scene{{}, half_space({0, 1, 0}, std::nextafter(1.0 / 3, 1))});
  EXPECT_TRUE(contains(view_of(more), ask, face));
  EXPECT_FALSE(contains(view_of(more), ask, std::nullopt)) << "the range's start";
}

TEST(FastExactEntry, CrossingsAreCorrectlyRounded) {
  EXPECT_EQ(crossing({{1, 0, 0}, 0}, {{1, 0, 0}, {-2, 0, 0}}), 1.0 / 3);
  EXPECT_EQ(crossing({{0, -3, 0}, 0}, {{0, 2, 0}, {0, -5, 0}}), 2.0 / 7);
  EXPECT_EQ(crossing({{0, -3, 0}, 0}, {{0, -2, 0}, {0, -9, 0}}), -2.0 / 7);
}

class SmallSolids {
 public:
  explicit SmallSolids(std::uint64_t seed) : random_(seed) {}

  double number() { return static_cast<double>(random_() % 5) - 2; }
  Vector vector() { return {number(), number(), number()}; }
  Shape shape(int depth) {
    if (depth == 0 || random_() % 4 == 0) return half_space(vector(), number());
    std::vector<Shape> operands;
    for (std::size_t count = random_() % 4; count > 0; --count) operands.push_back(shape(depth - 1));
    return random_() % 2 ? unite(operands) : intersect(operands);
  }

 private:
  std::mt19937_64 random_;
};

// An operand that is never met, but whose offset is too long for the integers that would do without it.
TEST(FastExactEntry, IntegersOfEveryLengthAgree) {
  struct FarOperand {
    double offset;
    std::size_t words;
  };
  const FarOperand far_operands[] = {{-0x1.1p60, 2}, {-0x1.1p140, 4}, {-0x1.1p300, 0}};
  SmallSolids solids(1);
  std::size_t borders = 0;
  for (int i = 0; i < 20000; ++i) {
    const Shape shape = solids.shape(3);
    const EntryAsk ask{solids.vector(), solids.vector(), 0, 1.5};
    const fast::Scene scene = compile_with_solid(groundtruth::Scene{{}, shape});
    const auto expected = entry_of(scene, ask);
    ASSERT_EQ(expected ? expected->words : 1, 1u);
    borders += expected && expected->leaf;
    for (const FarOperand& far_operand : far_operands) {
      const Shape with_it = unite({shape, half_space({0, 0, 1}, far_operand.offset)});
      const fast::Scene longer = compile_with_solid(groundtruth::Scene{{}, with_it});
      const bool is_alone = longer.solid().leaves.size() != scene.solid().leaves.size() + 1;
      if (is_alone) continue;
      const auto got = entry_of(longer, ask);
      ASSERT_EQ(got, expected);
      ASSERT_EQ(got ? got->words : far_operand.words, far_operand.words);
    }
  }
  EXPECT_GT(borders, 2000u);
}

TEST(FastExactEntry, ALongFractionTakesMoreWords) {
  const Shape slab = box({0, -1, -1}, {1, 1, 1});
  const double a_little = 0x1p-52, third = 1.0 / 3;
  const auto words_of = [](const std::optional<Entry>& entry) { return entry.value().words; };
  EXPECT_EQ(words_of(entry_of(slab, {{-1, 0, 0}, {2, 0, 0}})), 1u);
  EXPECT_EQ(words_of(entry_of(slab, {{-1 - a_little, 0, 0}, {2, 0, third}})), 1u);
  EXPECT_EQ(words_of(entry_of(slab, {{-1, 0, 0}, {2, third, 0}, third, 1})), 2u);
  const Shape skew = half_space({third, 0.1, 0.7}, 0.3);
  EXPECT_EQ(words_of(entry_of(skew, {{9, third, 0}, {-9, 0.1, 0}})), 2u);
  EXPECT_EQ(words_of(entry_of(skew, {{9, third, 0}, {-9, 0.1, 0}, third, 1})), 4u);
  EXPECT_EQ(words_of(entry_of(skew, {{9, third, 0}, {-9, 0x1p-900, 0}})), 0u);
}

}  // namespace
}  // namespace groundtruth::fast::exact_stage
