#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <groundtruth/definition/nearest_double.hpp>

namespace groundtruth::definition {
namespace {

constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = 0x1p-1074;

Rational power(int exponent) { return rational(std::ldexp(1.0, exponent)); }

// The same number, but not known to be plain.
Real disguised(const Rational& x) { return Real::root(4) * Rational(x / 2); }

// Both ways must agree.
std::optional<double> nearest(const Rational& x) {
  const std::optional<double> plain = nearest_double(x);
  EXPECT_EQ(nearest_double(disguised(x)), plain);
  return plain;
}

double some_finite_double() {
  const double x = std::bit_cast<double>(*rc::gen::arbitrary<std::uint64_t>());
  RC_PRE(std::isfinite(x));
  return x;
}

TEST(NearestDouble, BreaksTiesToEven) {
  EXPECT_EQ(nearest(1 + power(-53)), 1.0);
  EXPECT_EQ(nearest(1 + 3 * power(-53)), 1 + 0x1p-51);
  EXPECT_EQ(nearest(-1 - power(-53)), -1.0);
  EXPECT_EQ(nearest(1 - power(-54)), 1.0);
  EXPECT_EQ(nearest(1 - 3 * power(-54)), 1 - 0x1p-52);
}

TEST(NearestDouble, LeavesATieByTheLeastAmount) {
  const Rational tiny(Integer(1), pow(Integer(10), 400));
  EXPECT_EQ(nearest(1 + power(-53) + tiny), 1 + 0x1p-52);
  EXPECT_EQ(nearest(1 + 3 * power(-53) - tiny), 1 + 0x1p-52);
}

TEST(NearestDouble, RoundsSubnormalsAtTheirOwnUnit) {
  const Rational unit = power(-1074);
  EXPECT_EQ(nearest(unit), smallest);
  EXPECT_EQ(nearest(unit * Rational(3, 2)), 2 * smallest);
  EXPECT_EQ(nearest(unit * Rational(5, 2)), 2 * smallest);
  EXPECT_EQ(nearest(unit / 2 + unit / 1000), smallest);
  EXPECT_EQ(nearest(power(-1022) - unit / 2), 0x1p-1022);
  EXPECT_EQ(nearest(power(-1022) - unit * Rational(51, 100)), 0x1p-1022 - smallest);
}

TEST(NearestDouble, GivesPlusZeroForWhatVanishes) {
  for (const Rational& x :
       {Rational(0), Rational(power(-1074) / 2), Rational(-power(-1074) / 2), Rational(-power(-1074) / 3)}) {
    ASSERT_EQ(nearest(x), 0.0);
    EXPECT_FALSE(std::signbit(*nearest_double(x)));
    EXPECT_FALSE(std::signbit(*nearest_double(disguised(x))));
  }
}

TEST(NearestDouble, EndsWhereTheRangeOfDoublesEnds) {
  const Rational past_the_end = rational(largest) + power(970);
  EXPECT_EQ(nearest(past_the_end), std::nullopt);
  EXPECT_EQ(nearest(-past_the_end), std::nullopt);
  EXPECT_EQ(nearest(past_the_end - 1), largest);
  EXPECT_EQ(nearest(1 - past_the_end), -largest);
}

TEST(NearestDouble, OfARootIsTheCorrectlyRoundedRoot) {
  for (const double x : {2.0, 3.0, 0.1, 1e300, 7e-300, 1.5 * smallest})
    EXPECT_EQ(nearest_double(square_root(rational(x))), std::sqrt(x)) << x;
}

TEST(NearestDouble, OfACancellationBeyondTheDigitsOfAnyGuess) {
  // (sqrt 2 - 1)^n = a - b sqrt 2 with a, b near (sqrt 2 + 1)^n: from n = 110 on, 100 digits are too few.
  // It is the inverse of (sqrt 2 + 1)^n, which loses no digit.
  const Real root = square_root(Rational(2));
  Real small = 1, large = 1;
  for (int n = 1; n <= 160; ++n) {
    small = small * (root - Real(1));
    large = large * (root + Real(1));
    const double product = *nearest_double(small) * *nearest_double(large);
    ASSERT_NEAR(product, 1, 4e-16) << n;
    ASSERT_EQ(*nearest_double(-small), -*nearest_double(small)) << n;
  }
}

RC_GTEST_PROP(NearestDouble, OfADoubleIsItself, ()) {
  const double x = some_finite_double();
  RC_ASSERT(nearest_double(rational(x)) == x);
  RC_ASSERT(nearest_double(disguised(rational(x))) == x);
}

RC_GTEST_PROP(NearestDouble, AgreesWithTheProcessorOnSumsAndProducts, ()) {
  const double x = some_finite_double(), y = some_finite_double();
  const auto expected = [](double z) { return std::isfinite(z) ? std::optional(z) : std::nullopt; };
  RC_ASSERT(nearest_double(Rational(rational(x) + rational(y))) == expected(x + y));
  RC_ASSERT(nearest_double(Rational(rational(x) * rational(y))) == expected(x * y));
  RC_ASSERT(nearest_double(disguised(rational(x) * rational(y))) == expected(x * y));
  RC_PRE(y != 0);
  RC_ASSERT(nearest_double(Rational(rational(x) / rational(y))) == expected(x / y));
}

}  // namespace
}  // namespace groundtruth::definition
