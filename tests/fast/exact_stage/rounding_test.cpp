#include <groundtruth/fast/exact_stage/rounding.hpp>

#include <bit>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace groundtruth::fast::exact_stage {
namespace {

constexpr double largest = 0x1.fffffffffffffp1023;

double any_double(std::mt19937_64& random) {
  for (;;) {
    const auto x = std::bit_cast<double>(random());
    if (std::isfinite(x)) return x;
  }
}

Surd root_of_first() { return {{}, 1.0, {}}; }

// The machine's division and root round correctly too.
TEST(FastNearestDouble, OfAQuotientIsTheMachinesQuotient) {
  std::mt19937_64 random(1);
  std::size_t subnormal = 0, overflows = 0;
  for (int i = 0; i < 200000; ++i) {
    const double a = any_double(random), b = std::abs(any_double(random));
    if (b == 0) continue;
    const double expected = a / b;
    const auto got = nearest_double(Dyadic(a), Dyadic(b));
    if (std::abs(expected) < 0x1p-1022) ++subnormal;
    if (std::isinf(expected)) {
      ++overflows;
      ASSERT_EQ(got, std::nullopt) << a << " / " << b;
    } else {
      ASSERT_EQ(got, expected) << a << " / " << b;
    }
  }
  EXPECT_GT(subnormal, 100u);
  EXPECT_GT(overflows, 100u);
}

TEST(FastNearestDouble, OfARootIsTheMachinesRoot) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 20000; ++i) {
    const double x = std::abs(any_double(random));
    ASSERT_EQ(nearest_double(root_of_first(), {x, {}}, 1.0), std::sqrt(x)) << x;
    ASSERT_EQ(nearest_double(-root_of_first(), {x, {}}, 1.0), x == 0 ? 0 : -std::sqrt(x)) << x;
  }
}

TEST(FastNearestDouble, TiesGoToEven) {
  const Dyadic unit(0x1p-53);
  EXPECT_EQ(nearest_double(Dyadic(1.0) + unit, 1.0), 1.0);
  EXPECT_EQ(nearest_double(Dyadic(1.0) + unit * 3.0, 1.0), 1 + 0x1p-51);
  EXPECT_EQ(nearest_double(Dyadic(1.0) + unit + Dyadic(0x1p-1000), 1.0), 1 + 0x1p-52);
  EXPECT_EQ(nearest_double(Dyadic(0x1p-1074), 2.0), 0.0);
  EXPECT_EQ(nearest_double(Dyadic(0x3p-1074), 2.0), 0x1p-1073);
  EXPECT_EQ(nearest_double(Dyadic(0x1p-1074), 4.0), 0.0);
}

TEST(FastNearestDouble, TiesBetweenRootsGoToEven) {
  // 1 + 2^-54 sqrt(4), and the same with a root that is no double.
  EXPECT_EQ(nearest_double(Surd{1.0, 0x1p-54, {}}, {4.0, {}}, 1.0), 1.0);
  EXPECT_EQ(nearest_double(Surd{1 + 0x1p-52, 0x1p-54, {}}, {4.0, {}}, 1.0), 1 + 0x1p-51);
  EXPECT_EQ(nearest_double(Surd{1.0, 0x1p-54, {}}, {4 + 0x1p-50, {}}, 1.0), 1 + 0x1p-52);
  // sqrt(8) - 2 sqrt(2) = 0.
  EXPECT_EQ(nearest_double(Surd{1 + 0x1p-52, 1.0, -2.0}, {8.0, 2.0}, 1.0), 1 + 0x1p-52);
}

TEST(FastNearestDouble, EndsAtTheLargestDouble) {
  const Dyadic half_step(0x1p970);
  EXPECT_EQ(nearest_double(Dyadic(largest), 1.0), largest);
  EXPECT_EQ(nearest_double(Dyadic(largest) + half_step - Dyadic(1.0), 1.0), largest);
  EXPECT_EQ(nearest_double(Dyadic(largest) + half_step, 1.0), std::nullopt);
  EXPECT_EQ(nearest_double(Surd{largest, 0x1p969, {}}, {3.0, {}}, 1.0), largest);
  EXPECT_EQ(nearest_double(Surd{largest, 0x1p969, {}}, {4.0, {}}, 1.0), std::nullopt);
  EXPECT_EQ(nearest_double(Surd{largest, 0x1p969, {}}, {5.0, {}}, 1.0), std::nullopt);
}

TEST(FastSurdSign, SeesThroughCancellation) {
  EXPECT_EQ(sign(Surd{{}, 1.0, -2.0}, {8.0, 2.0}), 0);
  EXPECT_EQ(sign(Surd{0x1p-1000, 1.0, -2.0}, {8.0, 2.0}), 1);
  EXPECT_EQ(sign(Surd{-0x1p-1000, 1.0, -2.0}, {8.0, 2.0}), -1);
  // sqrt(2) + sqrt(3) against its decimals, 3.14626436994197234232913506571557...
  EXPECT_EQ(sign(Surd{-3.1462643699419721, 1.0, 1.0}, {2.0, 3.0}), 1);
  EXPECT_EQ(sign(Surd{-3.1462643699419726, 1.0, 1.0}, {2.0, 3.0}), -1);
}

// x - sqrt(x^2 + 1) = -1 / (x + sqrt(x^2 + 1)), which is near -1 / 2x for a large x.
TEST(FastNearestDouble, OfACancellingSumIsNotLost) {
  for (const double x : {0x1p40, 0x1p100, 0x1p400}) {
    const Dyadic radicand = square(Dyadic(x)) + Dyadic(1.0);
    EXPECT_EQ(nearest_double(Surd{x, -1.0, {}}, {radicand, {}}, 1.0), -0.5 / x) << x;
  }
}

}  // namespace
}  // namespace groundtruth::fast::exact_stage
