#include <array>
#include <cmath>
#include <limits>
#include <set>

#include <gtest/gtest.h>

#include <groundtruth/cases/random.hpp>

namespace groundtruth::cases {
namespace {

TEST(Random, BitsAreThoseThatTheStandardFixes) {
  Random random(5489);  // the default seed of std::mt19937_64, whose 10,000th number the standard names
  for (int i = 0; i < 9999; ++i) random.bits();
  EXPECT_EQ(random.bits(), 9981545732273789042u);
}

TEST(Random, BelowReachesEveryValueAboutAsOften) {
  Random random(1);
  std::array<int, 7> counts{};
  for (int i = 0; i < 7000; ++i) ++counts[random.below(7)];
  for (int count : counts) EXPECT_NEAR(count, 1000, 150);
}

TEST(Random, BelowIsUniformForACountThatDoesNotDivideTheRange) {
  // The remainders of 64 bits by 3 * 2^62 are below 2^62 half of the time, not a third of it.
  Random random(2);
  int in_first_third = 0;
  for (int i = 0; i < 3000; ++i) {
    const std::uint64_t value = random.below(3ull << 62);
    ASSERT_LT(value, 3ull << 62);
    in_first_third += value < 1ull << 62;
  }
  EXPECT_NEAR(in_first_third, 1000, 150);
}

TEST(Random, BetweenReachesBothEnds) {
  Random random(3);
  std::set<std::int64_t> seen;
  for (int i = 0; i < 200; ++i) seen.insert(random.between(-2, 2));
  EXPECT_EQ(seen, (std::set<std::int64_t>{-2, -1, 0, 1, 2}));
}

TEST(Random, UnitIsInTheHalfOpenUnitInterval) {
  Random random(4);
  double least = 1;
  double most = 0;
  for (int i = 0; i < 10000; ++i) {
    const double value = random.unit();
    least = std::min(least, value);
    most = std::max(most, value);
  }
  EXPECT_GE(least, 0);
  EXPECT_LT(least, 0.01);
  EXPECT_LT(most, 1);
  EXPECT_GT(most, 0.99);
}

TEST(Random, DyadicIsAMultipleOfItsUnitWithinItsBounds) {
  Random random(5);
  for (int i = 0; i < 1000; ++i) {
    const double value = random.dyadic(-3, 2, 4);
    EXPECT_EQ(value * 16, std::floor(value * 16));
    EXPECT_GE(value, -3);
    EXPECT_LE(value, 2);
  }
}

TEST(Random, PartsOfASeedDiffer) {
  std::set<std::uint64_t> seeds;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    for (std::uint64_t part = 0; part < 100; ++part) seeds.insert(seed_of_part(seed, part));
  }
  EXPECT_EQ(seeds.size(), 10000u);
}

TEST(BitPatternDouble, IsFiniteAndOfEveryKind) {
  Random random(6);
  int negative_zeros = 0, subnormals = 0, huge = 0, next_to_one = 0, integers = 0;
  for (int i = 0; i < 20000; ++i) {
    const double value = bit_pattern_double(random);
    ASSERT_TRUE(std::isfinite(value));
    negative_zeros += value == 0 && std::signbit(value);
    subnormals += std::fpclassify(value) == FP_SUBNORMAL;
    huge += std::abs(value) > 1e200;
    next_to_one += value == std::nextafter(1.0, 2.0) || value == std::nextafter(1.0, 0.0);
    integers += value != 0 && value == std::floor(value) && std::abs(value) <= 16;
  }
  EXPECT_GT(negative_zeros, 500);
  EXPECT_GT(subnormals, 500);
  EXPECT_GT(huge, 100);
  EXPECT_GT(next_to_one, 10);
  EXPECT_GT(integers, 1000);
}

TEST(OneUlpOff, IsTheNumberOrOneOfItsNeighbours) {
  Random random(7);
  std::set<double> seen;
  for (int i = 0; i < 100; ++i) seen.insert(one_ulp_off(0.1, random));
  EXPECT_EQ(seen, (std::set<double>{std::nextafter(0.1, 0.0), 0.1, std::nextafter(0.1, 1.0)}));
}

TEST(OneUlpOff, LeavesZeroForTheSmallestSubnormalOrAnUlpOfOne) {
  Random random(8);
  std::set<double> sizes;
  for (int i = 0; i < 100; ++i) sizes.insert(std::abs(one_ulp_off(0.0, random)));
  EXPECT_EQ(sizes, (std::set<double>{0, std::numeric_limits<double>::denorm_min(), 0x1p-52}));
}

}  // namespace
}  // namespace groundtruth::cases
