#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <groundtruth/definition/real.hpp>
#include <groundtruth/definition/surd.hpp>

namespace groundtruth::definition {
namespace {

using Float = boost::multiprecision::cpp_bin_float_100;

Real root(int radicand) { return square_root(Rational(radicand)); }

Float approximation(const Real& x) {
  if (x.is_plain()) return Float(numerator(x.plain())) / Float(denominator(x.plain()));
  return approximation(x.without_root()) + approximation(x.root_factor()) * sqrt(Float(x.radicand()));
}

// A sum of products of up to three roots with small coefficients; near 0 now and then, and at times 0 itself.
Real some_real() {
  Real sum = *rc::gen::inRange(-4, 5);
  for (int i = 0; i < 4; ++i) {
    Real product = *rc::gen::inRange(-3, 4);
    for (int factors = *rc::gen::inRange(0, 4); factors > 0; --factors)
      product = product * root(*rc::gen::element(2, 3, 5, 6, 8, 15, 18, 45));
    sum = sum + product * Rational(1, *rc::gen::inRange(1, 4));
  }
  return sum;
}

TEST(Surd, RootOfARationalSquareIsPlain) {
  const Real r = square_root(Rational(9, 4));
  ASSERT_TRUE(r.is_plain());
  EXPECT_EQ(r.plain(), Rational(3, 2));
  EXPECT_TRUE(square_root(Rational(0)).is_plain());
}

TEST(Surd, RootSquaredIsPlainAgain) {
  const Real x = (root(2) * root(3) + root(5)) * (root(2) * root(3) - root(5));
  ASSERT_TRUE(x.is_plain());
  EXPECT_EQ(x.plain(), 1);
}

TEST(Surd, SignTellsNearlyEqualSumsApart) {
  // sqrt 2 + sqrt 3 against 3.14626436994197234232913506571557 (rounded down) and its successor.
  const Real sum = root(2) + root(3);
  const Integer scale = pow(Integer(10), 32);
  const Rational below(Integer("314626436994197234232913506571557"), scale);
  EXPECT_EQ((sum - Real(below)).sign(), 1);
  EXPECT_EQ((sum - Real(Rational(below + Rational(Integer(1), scale)))).sign(), -1);
}

TEST(Surd, SignSeesThroughRootsThatDependOnEachOther) {
  EXPECT_EQ((root(18) - Rational(3) * root(2)).sign(), 0);
  EXPECT_EQ((root(8) - Rational(2) * root(2)).sign(), 0);
  EXPECT_EQ((root(6) - root(2) * root(3)).sign(), 0);
  EXPECT_EQ((Real::root(4) - Real(2)).sign(), 0);
  EXPECT_EQ(
      (root(6) + root(10) + root(15) - root(2) * root(3) - root(2) * root(5) - root(3) * root(5)).sign(), 0);
}

TEST(Surd, InverseOfANumberWhoseConjugateIsZero) {
  const Real x = root(18) + Rational(3) * root(2);
  EXPECT_EQ((x * x.inverse() - Real(1)).sign(), 0);
}

RC_GTEST_PROP(Surd, SignIsThatOfTheNumber, ()) {
  const Real x = some_real();
  const Float value = approximation(x);
  // Numbers of this size that are not 0 are far above 1e-60.
  const int expected = abs(value) < Float("1e-60") ? 0 : value > 0 ? 1 : -1;
  RC_ASSERT(x.sign() == expected);
}

RC_GTEST_PROP(Surd, SignOfANearZeroProductWithItsConjugatesIsThatOfTheNumber, ()) {
  // (root - floor(root))^n is tiny and positive.
  const int radicand = *rc::gen::element(2, 3, 5, 7, 10);
  const Real fraction = root(radicand) - Real(static_cast<int>(std::sqrt(radicand)));
  Real power = 1;
  for (int n = *rc::gen::inRange(1, 60); n > 0; --n) power = power * fraction;
  RC_ASSERT(power.sign() == 1);
  RC_ASSERT((-power).sign() == -1);
}

RC_GTEST_PROP(Surd, ArithmeticIsThatOfTheNumbers, ()) {
  const Real x = some_real(), y = some_real();
  const Float a = approximation(x), b = approximation(y);
  RC_ASSERT(abs(approximation(x + y) - (a + b)) < Float("1e-80"));
  RC_ASSERT(abs(approximation(x - y) - (a - b)) < Float("1e-80"));
  RC_ASSERT(abs(approximation(x * y) - a * b) < Float("1e-80"));
}

RC_GTEST_PROP(Surd, InverseTimesTheNumberIsOne, ()) {
  const Real x = some_real();
  RC_PRE(x.sign() != 0);
  RC_ASSERT((x * x.inverse() - Real(1)).sign() == 0);
}

}  // namespace
}  // namespace groundtruth::definition
