#include <groundtruth/precision/ulps.hpp>

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace groundtruth::precision {
namespace {

TEST(ErrorInUlps, IsThatOfTheExactNumberAndNotOfItsRounding) {
  // 1/3 lies a third of an ulp above its nearest double, which is 0x1.5555555555555p-2.
  EXPECT_NEAR(error_in_ulps(1.0 / 3, "1/3"), 1.0 / 3, 1e-15);
  EXPECT_NEAR(error_in_ulps(std::nextafter(1.0 / 3, 1), "1/3"), 2.0 / 3, 1e-15);
  EXPECT_NEAR(error_in_ulps(std::nextafter(1.0 / 3, 0), "1/3"), 4.0 / 3, 1e-15);
  EXPECT_NEAR(error_in_ulps(-1.0 / 3, "-1/3"), 1.0 / 3, 1e-15);
}

TEST(ErrorInUlps, IsMeasuredInTheBinadeOfTheExactNumber) {
  EXPECT_EQ(error_in_ulps(0.5, "0.5"), 0);
  EXPECT_EQ(error_in_ulps(1.0, "1"), 0);
  EXPECT_EQ(error_in_ulps(1 + 0x1p-52, "1"), 1);
  EXPECT_EQ(error_in_ulps(1 - 0x1p-53, "1"), 0.5) << "the ulp is that of [1, 2)";
  EXPECT_EQ(error_in_ulps(2, "1"), 0x1p52);
}

TEST(ErrorInUlps, KnowsZeroSubnormalsAndNoNumbers) {
  EXPECT_EQ(error_in_ulps(0, "0"), 0);
  EXPECT_EQ(error_in_ulps(0x1p-1074, "0"), 1);
  EXPECT_EQ(error_in_ulps(0x1p-1073, "0"), 2);
  EXPECT_EQ(error_in_ulps(1, "0"), std::numeric_limits<double>::max()) << "2^1074 is beyond";
  EXPECT_EQ(error_in_ulps(NAN, "1"), std::numeric_limits<double>::max());
  EXPECT_EQ(error_in_ulps(INFINITY, "1"), std::numeric_limits<double>::max());
}

TEST(ErrorInUlps, ReadsDecimalsToTheLastDigit) {
  EXPECT_EQ(error_in_ulps(1.5, "1.5"), 0);
  EXPECT_EQ(error_in_ulps(-0.0025, "-2.5e-3"), error_in_ulps(-0.0025, "-1/400"));
  EXPECT_EQ(error_in_ulps(0.1, "0.1"), error_in_ulps(0.1, "1/10"));
  EXPECT_NEAR(error_in_ulps(1, "1.00000000000000011102230246251565404236316680908203125"), 0.5, 1e-12);
}

TEST(ErrorOfAVector, IsMeasuredByItsLargestComponent) {
  const Answer exact = ClipAnswer(Clipped{Grip::slip, {1, 8, 0}});
  const Evidence evidence{"", {}, {{"force[0]", "1", "1"}, {"force[1]", "8", "8"}, {"force[2]", "0", "0"}}};
  EXPECT_EQ(error_in_ulps(ClipAnswer(Clipped{Grip::slip, {1, 8, 0}}), exact, evidence), 0);
  EXPECT_EQ(error_in_ulps(ClipAnswer(Clipped{Grip::slip, {1 + 0x1p-52, 8, 0}}), exact, evidence), 0.125);
  EXPECT_EQ(error_in_ulps(ClipAnswer(Clipped{Grip::slip, {1, 8, 0x1p-48}}), exact, evidence), 2);
}

TEST(ErrorOfAnEntry, IsThatOfLambda) {
  const Answer exact = EntryAnswer(Border{1.0 / 3, 0, {0, 0, 1}, {}});
  const Evidence evidence{"1/3", {0}, {}};
  EXPECT_NEAR(error_in_ulps(exact, exact, evidence), 1.0 / 3, 1e-15);
  EXPECT_EQ(error_in_ulps(EntryAnswer(Miss{}), EntryAnswer(Miss{}), {}), 0);
}

}  // namespace
}  // namespace groundtruth::precision
