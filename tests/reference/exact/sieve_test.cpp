#include <groundtruth/exact/solid/sieve.hpp>

#include <gtest/gtest.h>

namespace groundtruth::exact {
namespace {

PointEnclosure point(double x, double y, double z) { return {{{x, x}, {y, y}, {z, z}}}; }

// x <= 0 and y <= 0, or nothing but z <= 0.
Solid corner_or_ground() {
  return {{{Operation::united, 5},
           {Operation::intersected, 4},
           {Operation::leaf, 3, 0},
           {Operation::leaf, 4, 1},
           {Operation::leaf, 5, 2}},
          {{{1, 0, 0}, 0}, {{0, 1, 0}, 0}, {{0, 0, 1}, 0}}};
}

std::vector<Leaf> left_over(const Expression& expression) {
  std::vector<Leaf> leaves;
  for (const Node& node : expression) {
    if (node.operation == Operation::leaf) leaves.push_back(node.leaf);
  }
  return leaves;
}

TEST(Sieve, DropsWhatHoldsAllAlong) {
  EXPECT_EQ(left_over(sieve(corner_or_ground(), point(-1, 2, 3), point(-1, -2, 3))), (std::vector<Leaf>{1}));
}

TEST(Sieve, AnOperandThatSwallowsLeavesAConstant) {
  const Expression below = sieve(corner_or_ground(), point(-1, -1, -1), point(2, 2, -1));
  ASSERT_EQ(below.size(), 1U);
  EXPECT_EQ(below[0].operation, Operation::everything);
  const Expression above = sieve(corner_or_ground(), point(1, 1, 1), point(2, -1, 1));
  ASSERT_EQ(above.size(), 1U);
  EXPECT_EQ(above[0].operation, Operation::nothing);
}

TEST(Sieve, KeepsALeafThatTouches) {
  EXPECT_EQ(left_over(sieve(corner_or_ground(), point(5, 5, 1), point(5, 5, 0))), (std::vector<Leaf>{2}));
}

TEST(Sieve, KeepsWhatRoundingCannotTell) {
  // 0.1 x + 0.2 y - 0.3 z at (1, 1, 1) is 2^-55 or so, below what its terms' rounding can tell.
  const Solid solid{{{Operation::leaf, 1, 0}}, {{{0.1, 0.2, -0.3}, 0}}};
  EXPECT_EQ(left_over(sieve(solid, point(1, 1, 1), point(1, 1, 1))), (std::vector<Leaf>{0}));
}

TEST(Sieve, KeepsWhatOverflows) {
  const Solid solid{{{Operation::leaf, 1, 0}}, {{{1e300, -1e300, 0}, 1}}};
  EXPECT_EQ(left_over(sieve(solid, point(1e300, 1e300, 0), point(1e300, 1e300, 0))), (std::vector<Leaf>{0}));
}

}  // namespace
}  // namespace groundtruth::exact
