// Explained entries say what the exact engine answers, and what they say of other decisions comes true.

#include <gtest/gtest.h>

#include "explaining.hpp"

namespace groundtruth::explanation {
namespace {

const EntryFacts& entry_in(const Explanation& explanation) { return std::get<EntryFacts>(explanation.facts); }

TEST(ExplainedEntry, AgreesWithTheExactEngineOnTheCorpus) {
  std::size_t entries = 0;
  for (const cases::Case& one : cases::corpus()) {
    if (!std::holds_alternative<EntryAsk>(one.ask)) continue;
    ++entries;
    expect_same_decision(one);
  }
  EXPECT_GT(entries, 50U);
}

TEST(ExplainedEntry, AgreesWithTheExactEngineOnDegenerateAndNestedScenes) {
  for (const char* name : {"degenerate", "nested"}) {
    std::uint64_t seed = 20261126;
    for (const Scene& scene : cases::find_builtin_scene(name)->build()) {
      if (planes_of(scene.shape).size() > 12) continue;
      cases::AskSource source(scene, ++seed, {1, 0, 0});
      for (int i = 0; i < 6; ++i) expect_same_decision({name, scene, source.next().ask, {}, {}});
    }
  }
}

TEST(ExplainedEntry, LightsTheSolidFirstWhereItIsEntered) {
  const Explanation seam = explained("seam/across-it-from-the-rim");
  for (const Stop& stop : entry_in(seam).stops) {
    const Rational& lambda = *entry_in(seam).decision.lambda;
    if (stop.from < lambda) {
      EXPECT_FALSE(stop.lit.front());
    }
    if (stop.is_breakpoint() && stop.from == lambda) {
      EXPECT_TRUE(stop.lit.front());
    }
  }
}

std::string difference_of(const std::string& who, const Explanation& explanation) {
  for (const Opinion& opinion : explanation.opinions)
    if (opinion.who == who) return opinion.difference;
  return "says nothing";
}

TEST(ExplainedEntry, TellsWhatEachKindOfArithmeticAnswers) {
  const Explanation at_a_third = explained("grazing/top-plane");
  EXPECT_EQ(difference_of("float", at_a_third), "differs in lambda");
  EXPECT_EQ(difference_of("interval", explained("sheet/one-ulp-thick")), "is undecided");
  EXPECT_EQ(difference_of("mpfr-256", at_a_third), "");
  EXPECT_EQ(difference_of("cgal-lazy", explained("clip/case-2-corner")),
            "does not answer this: its numbers have no square roots");
}

TEST(ExplainedEntry, NamesTheSeamAsWhatItIs) {
  const Explanation seam = explained("seam/inside-it");
  bool seen = false;
  for (const TiedFace& face : entry_in(seam).decision.meeting.faces) seen |= face.role == Role::behind;
  EXPECT_TRUE(seen);
}

// The engine is asked on a scene with the plane where the explanation puts it.
TEST(ExplainedEntry, ASegmentOneUlpAboveAFaceHitsIfTheFaceIsRaisedByThatUlp) {
  const Explanation miss = explained("grazing/one-ulp-above");
  ASSERT_FALSE(entry_in(miss).decision.lambda);
  ASSERT_EQ(entry_in(miss).search.flips.size(), 1U);
  const Flip& flip = entry_in(miss).search.flips.front();
  EXPECT_EQ(flip.what, Flips::hit_or_miss);
  EXPECT_TRUE(flip.is_reached);
  Scene moved = miss.asked.scene;
  const double offset =
      Rational(entry_in(miss).in_play.planes[flip.plane].offset + flip.offset_change).convert_to<double>();
  moved.shape = with_offset(moved.shape, entry_in(miss).in_play.planes[flip.plane].leaf, offset);
  EXPECT_TRUE(is_hit(moved, miss.asked.ask));
  moved.shape =
      with_offset(moved.shape, entry_in(miss).in_play.planes[flip.plane].leaf, std::nextafter(offset, -1e9));
  EXPECT_FALSE(is_hit(moved, miss.asked.ask));
}

TEST(ExplainedEntry, ASegmentInAFacePlaneMissesAsSoonAsTheFaceIsLowered) {
  const Explanation grazing = explained("grazing/top-plane");
  const auto& flips = entry_in(grazing).search.flips;
  ASSERT_FALSE(flips.empty());
  EXPECT_EQ(flips.front().offset_change, 0);
  EXPECT_FALSE(flips.front().is_reached);
}

TEST(ExplainedEntry, LeavesOutOfLargeScenesOnlyWhatDecidesTheSame) {
  const Scene town = cases::find_builtin_scene("town")->build().front();
  cases::AskSource source(town, 7, {1, 0, 0});
  for (int i = 0; i < 3; ++i) {
    const cases::Case one{"town", town, source.next().ask, {}, {}};
    expect_same_decision(one);
  }
}

}  // namespace
}  // namespace groundtruth::explanation
