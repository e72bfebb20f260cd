#include <groundtruth/fast/number_traced.hpp>

#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <groundtruth/fast/exact_stage/dyadic.hpp>

namespace groundtruth::fast {
namespace {

using exact_stage::Dyadic;

// Of few bits often, of any often enough; sometimes 0.
TracedPair any_pair() {
  const auto any_double = [] {
    const auto significand = *rc::gen::arbitrary<std::int64_t>();
    const int bits = *rc::gen::inRange(0, 54);
    return std::ldexp(static_cast<double>(bits == 0 ? 0 : significand >> (64 - bits)),
                      *rc::gen::inRange(-60, 60));
  };
  return TracedPair::sum(any_double(), any_double());
}

Dyadic exactly(const TracedPair& x) { return Dyadic(x.high) + Dyadic(x.low); }

bool are_same_pairs(const TracedPair& traced, const Pair& pair) {
  return traced.high == pair.high && traced.low == pair.low;
}
Pair untraced(const TracedPair& x) { return {x.high, x.low}; }

RC_GTEST_PROP(TracedPairs, ThatSayTheyAreExactAre, ()) {
  const TracedPair a = any_pair(), b = any_pair();
  if ((a + b).is_exact) RC_ASSERT(exactly(a + b) == exactly(a) + exactly(b));
  if ((a * b).is_exact) RC_ASSERT(exactly(a * b) == exactly(a) * exactly(b));
  if (b.high != 0 && (a / b).is_exact) RC_ASSERT(exactly(a / b) * exactly(b) == exactly(a));
  if (a.high > 0 && sqrt(a).is_exact) RC_ASSERT(exactly(sqrt(a)) * exactly(sqrt(a)) == exactly(a));
}

RC_GTEST_PROP(TracedPairs, HaveTheValuesOfPairs, ()) {
  const TracedPair a = any_pair(), b = any_pair();
  RC_ASSERT(are_same_pairs(a + b, untraced(a) + untraced(b)));
  if (a.high != 0 && b.high != 0) {
    RC_ASSERT(are_same_pairs(a * b, untraced(a) * untraced(b)));
    RC_ASSERT(are_same_pairs(a / b, untraced(a) / untraced(b)));
  }
}

RC_GTEST_PROP(TracedPairs, OfFewBitsAreExact, ()) {
  const auto few = [] { return static_cast<double>(*rc::gen::inRange(1, 1 << 20)); };
  const TracedPair a = few(), b = few(), c = TracedPair::product(few(), few());
  RC_ASSERT((a * b + c).is_exact);
  RC_ASSERT((a * b * c).is_exact);
  RC_ASSERT((a * c / c).is_exact);
  RC_ASSERT(sqrt(a * a).is_exact);
}

TEST(TracedPairs, ForgetNothingThatWasLost) {
  const TracedPair third = TracedPair(1.0) / TracedPair(3.0);
  EXPECT_FALSE(third.is_exact);
  EXPECT_FALSE((third + 1).is_exact);
  EXPECT_FALSE((third * 3).is_exact);
  EXPECT_TRUE((third * 0.0).is_exact);
  EXPECT_FALSE(sqrt(TracedPair(2.0)).is_exact);
  EXPECT_FALSE(TracedPair::product(0x1p-600, 0x1p-600).is_exact);
}

TEST(TracedPairs, AreRoundedToEvenWhereTheyAreTies) {
  const Counted<TracedPair, 40> tie{TracedPair::sum(1, 0x1p-53), 1},
      other{TracedPair::sum(1 + 0x1p-52, 0x1p-53), 1};
  EXPECT_EQ(nearest_double(tie), 1);
  EXPECT_EQ(nearest_double(other), 1 + 0x1p-51);
  Counted<TracedPair, 40> unsure = tie;
  unsure.value.is_exact = false;
  EXPECT_EQ(nearest_double(unsure), std::nullopt);
}

}  // namespace
}  // namespace groundtruth::fast
