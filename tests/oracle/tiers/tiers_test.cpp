// What each tier's arithmetic owes: no error where its numbers are exact, none that its bounds exclude.

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <groundtruth/cases/ask_source.hpp>
#include <groundtruth/cases/builtin_scenes.hpp>
#include <groundtruth/cases/random.hpp>
#include <groundtruth/judge/difference.hpp>
#include <groundtruth/tiers/tier.hpp>

namespace groundtruth::tiers {
namespace {

const Tier& tier(const std::string& name) {
  const auto found =
      std::find_if(tiers().begin(), tiers().end(), [&](const auto& one) { return one->name() == name; });
  return **found;
}

// Every ask that the tier answers, of the built-in scenes, against the exact engine.
struct Agreement {
  std::size_t asked = 0, undecided = 0, kinds_differ = 0;
  double worst_ulps = 0;
};

bool is_decision(judge::Difference difference) {
  return difference != judge::Difference::none && difference != judge::Difference::lambda &&
         difference != judge::Difference::numbers && difference != judge::Difference::refusal;
}

void hold_against_exact(const Tier& tier, const Scene& scene, std::uint64_t seed, std::size_t count,
                        Agreement& agreement) {
  const auto on_scene = tier.on(scene);
  const auto exact = tiers::tiers()[11]->on(scene);
  cases::AskSource source(scene, seed);
  for (std::size_t i = 0; i < count; ++i) {
    const Ask ask = source.next().ask;
    if (tier.omission(kind_of(ask))) continue;
    ++agreement.asked;
    const TierAnswer said = on_scene->answer(ask);
    const auto* got = std::get_if<Answer>(&said);
    if (got == nullptr) {
      ++agreement.undecided;
      continue;
    }
    const Answer truth = std::get<Answer>(exact->answer(ask));
    const auto comparison = judge::compare({*got, {}}, {truth, {}});
    if (is_decision(comparison.difference)) {
      ++agreement.kinds_differ;
      ADD_FAILURE_AT(__FILE__, __LINE__) << tier.name() << " ask " << i << " of kind " << ask.index() << ": "
                                         << judge::name_of(comparison.difference);
      if (agreement.kinds_differ > 5) return;
    }
    agreement.worst_ulps = std::max(agreement.worst_ulps, comparison.lambda_ulps);
  }
}

Agreement over_builtin_scenes(const std::string& name, std::size_t asks_per_scene) {
  Agreement agreement;
  for (const cases::BuiltinScene& builtin : cases::builtin_scenes()) {
    const std::vector<Scene> pack = builtin.build();
    for (std::size_t part = 0; part < pack.size(); ++part)
      hold_against_exact(tier(name), pack[part], part, 1 + asks_per_scene / pack.size(), agreement);
  }
  return agreement;
}

TEST(Tiers, AreNamedInOrderAndDescribed) {
  std::vector<std::string> names;
  for (const auto& tier : tiers()) {
    names.push_back(tier->name());
    EXPECT_FALSE(tier->description().empty()) << tier->name();
  }
  EXPECT_EQ(names, (std::vector<std::string>{"float", "double", "as-written", "fast", "long-double",
                                             "double-double", "interval", "cpp_bin_float_50", "mpfr-128",
                                             "mpfr-256", "cgal-lazy", "exact", "definition"}));
}

TEST(LazyExactTier, TakesEveryDecisionAsTheReferenceDoes) {
  const Agreement agreement = over_builtin_scenes("cgal-lazy", 120);
  EXPECT_EQ(agreement.kinds_differ, 0U);
  EXPECT_EQ(agreement.undecided, 0U);
  EXPECT_LE(agreement.worst_ulps, 1);
  EXPECT_GT(agreement.asked, 400U);
}

TEST(IntervalTier, IsNeverCertainOfWhatIsWrong) {
  const Agreement agreement = over_builtin_scenes("interval", 400);
  EXPECT_EQ(agreement.kinds_differ, 0U);
  EXPECT_GT(agreement.undecided, 0U);
  EXPECT_LT(agreement.undecided, agreement.asked / 2);
}

// One plane in general position, its offset within the bound of the error for lambda: each rounding of
// Delta(x_1) and Delta(x_2) is at most 2^-p of the largest product, and w = Delta(x_1) - Delta(x_2) divides.
struct Precision {
  const char* tier;
  int bits;
};

RC_GTEST_PROP(PlainTiers, AreWithinTheErrorThatTheirPrecisionAllows, ()) {
  const Precision precision =
      *rc::gen::element(Precision{"float", 24}, Precision{"double", 53}, Precision{"long-double", 64},
                        Precision{"double-double", 100}, Precision{"cpp_bin_float_50", 168},
                        Precision{"mpfr-128", 128}, Precision{"mpfr-256", 257}, Precision{"cgal-lazy", 300});
  cases::Random random(*rc::gen::arbitrary<std::uint64_t>());
  const auto coordinates = [&] {
    return Vector{random.uniform(-8, 8), random.uniform(-8, 8), random.uniform(-8, 8)};
  };
  const HalfSpace plane{coordinates(), random.uniform(-8, 8)};
  const EntryAsk ask{coordinates(), coordinates()};
  const auto distance = [&](const Vector& x) {
    return plane.normal[0] * x[0] + plane.normal[1] * x[1] + plane.normal[2] * x[2] - plane.offset;
  };
  const double start = distance(ask.from), end = distance(ask.to);
  RC_PRE(start > 1 && end < -1);
  const Scene scene{{}, {plane}};
  const auto lambda = [&](const std::string& name) {
    const Answer answer = std::get<Answer>(tier(name).on(scene)->answer(ask));
    return std::get<Border>(std::get<EntryAnswer>(answer)).lambda;
  };
  constexpr double largest = 3 * 8 * 24 + 8, roundings = 24;
  const double bound = roundings * std::ldexp(largest, -precision.bits) / (start - end) + 0x1p-52;
  RC_ASSERT(std::abs(lambda(precision.tier) - lambda("exact")) <= bound);
}

TEST(ATableOfTiers, HasARowForEachAndSaysWhatIsOmitted) {
  const Scene scene{{}, {HalfSpace{{0, 0, 1}, 0}}};
  const std::vector<Row> rows = rows_for(scene, ClipAsk{{1, 2, 3}, {0, 0, -1}, 0.5, 10});
  ASSERT_EQ(rows.size(), tiers().size());
  for (const Row& row : rows) {
    const bool omitted = std::holds_alternative<Omitted>(row.said);
    EXPECT_EQ(omitted, row.name == "cgal-lazy") << row.name;
  }
}

}  // namespace
}  // namespace groundtruth::tiers
