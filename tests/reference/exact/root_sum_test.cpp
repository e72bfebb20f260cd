#include <groundtruth/exact/arithmetic/root_sum.hpp>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace groundtruth::exact {
namespace {

RootSum sum(const Rational& a, const Rational& b, const Rational& c, const Rational& radicand_a,
            const Rational& radicand_d) {
  return {a, b, c, std::make_shared<const Radicands>(Radicands{radicand_a, radicand_d})};
}

TEST(SignOfRootSum, TellsWhatDecimalsCannot) {
  // sqrt(2) + sqrt(3) against the truncations of its decimal expansion.
  const Rational below(
      "31462643699419723423291350657155704455124771291873/"
      "10000000000000000000000000000000000000000000000000");
  const Rational above = below + Rational(1, Integer("10000000000000000000000000000000000000000000000000"));
  EXPECT_EQ(sign(sum(-below, 1, 1, 2, 3)), 1);
  EXPECT_EQ(sign(sum(-above, 1, 1, 2, 3)), -1);
}

TEST(SignOfRootSum, KnowsZeroInDisguise) {
  EXPECT_EQ(sign(sum(-5, 1, 1, 4, 9)), 0) << "2 + 3 - 5";
  EXPECT_EQ(sign(sum(0, 2, -1, 2, 8)), 0) << "2 sqrt(2) - sqrt(8)";
  EXPECT_EQ(sign(sum(0, 3, 3, 0, 0)), 0);
  EXPECT_EQ(sign(sum(1, -1, 0, Rational(1), 7)), 0);
}

TEST(SignOfRootSum, RadicandsOfZeroVanish) {
  EXPECT_EQ(sign(sum(-1, 100, 0, 0, 0)), -1);
  EXPECT_EQ(sign(sum(1, 0, -100, 0, 0)), 1);
}

// With A = m^2 and D = n^2 the value is an integer, and its sign no secret.
RC_GTEST_PROP(SignOfRootSum, AgreesWithIntegersOnSquares,
              (std::int16_t a, std::int16_t b, std::int16_t c, std::int8_t m, std::int8_t n)) {
  const int root_m = m < 0 ? -m : m;
  const int root_n = n < 0 ? -n : n;
  const long value = static_cast<long>(a) + static_cast<long>(b) * root_m + static_cast<long>(c) * root_n;
  RC_ASSERT(sign(sum(a, b, c, root_m * root_m, root_n * root_n)) == (value > 0) - (value < 0));
}

// The enclosure is computed without the sign's algorithm; where it excludes zero the two must agree.
RC_GTEST_PROP(SignOfRootSum, AgreesWithItsEnclosure,
              (std::int16_t a, std::int16_t b, std::int16_t c, std::uint16_t radicand_a,
               std::uint16_t radicand_d)) {
  const RootSum value = sum(a, b, c, Rational(radicand_a) / 7, Rational(radicand_d) / 11);
  const auto [lower, upper] = value.enclosure(256);
  RC_ASSERT(lower <= upper);
  RC_ASSERT(upper - lower <= Rational(Integer(1), Integer(1) << 230));
  RC_ASSERT((sign(lower) > 0) <= (sign(value) > 0));
  RC_ASSERT((sign(upper) < 0) <= (sign(value) < 0));
}

RC_GTEST_PROP(RootSum, IsAVectorSpace, (std::int8_t a, std::int8_t b, std::int8_t c, std::int8_t factor)) {
  const auto roots = std::make_shared<const Radicands>(Radicands{2, 3});
  const RootSum left(a, b, c, roots);
  const RootSum right(c, a, b, roots);
  const Rational by(factor);
  RC_ASSERT(sign((left + right) * by - (left * by + right * by)) == 0);
  RC_ASSERT(sign(left - left) == 0);
  RC_PRE(factor != 0);
  RC_ASSERT(sign(left / by * by - left) == 0);
}

}  // namespace
}  // namespace groundtruth::exact
