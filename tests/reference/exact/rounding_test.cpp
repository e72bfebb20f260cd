#include <groundtruth/exact/arithmetic/rounding.hpp>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace groundtruth::exact {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();

Rational power_of_two(int exponent) {
  const Integer power = Integer(1) << static_cast<unsigned>(std::abs(exponent));
  return exponent < 0 ? Rational(Integer(1), power) : Rational(power);
}

RootSum with_root(const Rational& rational, const Rational& factor, const Rational& radicand) {
  return {rational, factor, 0, std::make_shared<const Radicands>(Radicands{radicand, 0})};
}

TEST(NearestDouble, TiesGoToEven) {
  EXPECT_EQ(nearest_double(1 + power_of_two(-53)), 1.0);
  EXPECT_EQ(nearest_double(1 + 3 * power_of_two(-53)), 1.0 + 0x1p-51);
  EXPECT_EQ(nearest_double(Rational(-1 - power_of_two(-53))), -1.0);
  EXPECT_EQ(nearest_double(1 + power_of_two(-53) + power_of_two(-300)), 1.0 + 0x1p-52);
}

TEST(NearestDouble, RoundsSubnormalsOnce) {
  EXPECT_EQ(nearest_double(power_of_two(-1075)), 0.0);
  EXPECT_FALSE(std::signbit(nearest_double(Rational(-power_of_two(-1075))))) << "never -0";
  EXPECT_EQ(nearest_double(power_of_two(-1075) + power_of_two(-2000)), smallest);
  EXPECT_EQ(nearest_double(3 * power_of_two(-1075)), 2 * smallest);
  // Rounding first to 53 bits, then to the subnormal, would go up here.
  EXPECT_EQ(nearest_double(power_of_two(-1074) + power_of_two(-1075) - power_of_two(-1130)), smallest);
}

TEST(NearestDouble, OverflowsWhereIeeeDoes) {
  const Rational border = power_of_two(1024) - power_of_two(970);
  EXPECT_EQ(nearest_double(border), infinity);
  EXPECT_EQ(nearest_double(border - power_of_two(-1000)), largest);
  EXPECT_EQ(nearest_double(Rational(-border)), -infinity);
}

TEST(NearestDouble, OfRootsTiesGoToEvenToo) {
  // sqrt(4) = 2 in disguise, so that the value is exactly halfway.
  EXPECT_EQ(nearest_double(with_root(power_of_two(-53) - 1, 1, 4)), 1.0);
  EXPECT_EQ(nearest_double(with_root(3 * power_of_two(-53) - 1, 1, 4)), 1.0 + 0x1p-51);
  EXPECT_EQ(nearest_double(with_root(-2, 1, 4)), 0.0);
  EXPECT_EQ(nearest_double(with_root(0, power_of_two(1023), 4)), infinity);
  EXPECT_EQ(nearest_double(with_root(-power_of_two(970), power_of_two(1023), 4)), infinity);
}

TEST(NearestDouble, OfRootsResolvesCancellation) {
  // sqrt(2^200 + 1) - 2^100 = 2^-101 to 200 bits.
  const Rational big = power_of_two(100);
  EXPECT_EQ(nearest_double(with_root(Rational(-big), 1, Rational(big * big + 1))), 0x1p-101);
}

TEST(NearestDouble, OfRootsAgreesWithIeeeSquareRoot) {
  for (const double value : {2.0, 3.0, 0.1, 1e300, 1e-300, 5e-324, 1.7976931348623157e308}) {
    EXPECT_EQ(nearest_double(with_root(0, 1, Rational(value))), std::sqrt(value)) << value;
  }
}

// IEEE division and square root round correctly; so the exact results, rounded, must be theirs.
double finite_double_of(std::uint64_t bits) {
  const double value = std::bit_cast<double>(bits);
  return value - value == 0 ? value : std::bit_cast<double>(bits & 0x800FFFFFFFFFFFFFULL);
}

RC_GTEST_PROP(NearestDouble, AgreesWithIeeeDivision, (std::uint64_t left_bits, std::uint64_t right_bits)) {
  const double left = finite_double_of(left_bits);
  const double right = finite_double_of(right_bits);
  RC_PRE(right != 0);
  RC_ASSERT(nearest_double(Rational(left) / Rational(right)) == left / right);
}

RC_GTEST_PROP(NearestDouble, AgreesWithIeeeSquareRoot, (std::uint64_t bits)) {
  const double value = std::fabs(finite_double_of(bits));
  RC_ASSERT(nearest_double(with_root(0, 1, Rational(value))) == std::sqrt(value));
}

TEST(DecimalEnclosure, IsTightAndClosesOnDecimals) {
  const Enclosure third = decimal_enclosure("x", RootSum(Rational(1, 3)), 5);
  EXPECT_EQ(third.lower, "33333e-5");
  EXPECT_EQ(third.upper, "33334e-5");
  const Enclosure negative = decimal_enclosure("x", with_root(0, -1, 2), 5);
  EXPECT_EQ(negative.lower, "-14143e-4");
  EXPECT_EQ(negative.upper, "-14142e-4");
  const Enclosure quarter = decimal_enclosure("x", with_root(Rational(-7, 4), 1, 4), 5);
  EXPECT_EQ(quarter.lower, "25000e-5");
  EXPECT_EQ(quarter.upper, quarter.lower);
  EXPECT_EQ(decimal_enclosure("x", with_root(-2, 1, 4), 5).lower, "0");
}

}  // namespace
}  // namespace groundtruth::exact
