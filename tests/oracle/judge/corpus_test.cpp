// The corpus keeps what it says of itself: ids, flags, and that a case with an erratum's name shows that
// erratum.

#include <algorithm>
#include <set>
#include <string>

#include <groundtruth/cases/corpus.hpp>

#include <gtest/gtest.h>

#include "judging.hpp"

namespace groundtruth::judge {
namespace {

// What corpus.hpp documents.
const std::set<std::string> documented = {
    "seam",        "corner",      "edge",    "sheet",      "grazing",   "start-on-face", "inside",
    "one-ulp",     "range",       "border",  "expression", "paint",     "empty",         "steep",
    "brake",       "band-corner", "tensile", "broken",     "big-world", "relocation",    "omega",
    "orientation", "damping",     "refusal", "gave-way",   "lift-off",  "friction",      "return-mapping"};

// SPEC section 7; those that no engine can make are no switches.
const std::set<std::string> errata = {
    "single-pass-intersection", "normal-by-order",     "miss-is-plus-1000",     "surface-frame-sign",
    "band-test-wheel-x",        "signed-normal-force", "force-on-frame-sign",   "no-liftoff",
    "tensile-contact",          "spring-relocation",   "frame-rotation-ignored"};
const std::set<std::string> errata_without_switch = {"house-corners", "mixed-frames"};

TEST(Corpus, HasDistinctIdsAndNotes) {
  std::set<std::string> ids;
  for (const cases::Case& one : cases::corpus()) {
    EXPECT_TRUE(ids.insert(one.id).second) << one.id;
    EXPECT_FALSE(one.note.empty()) << one.id;
    EXPECT_FALSE(one.flags.empty()) << one.id;
  }
}

TEST(Corpus, HasOnlyDocumentedFlagsAndEachOfThem) {
  std::set<std::string> unused = documented;
  unused.insert(errata.begin(), errata.end());
  for (const cases::Case& one : cases::corpus()) {
    for (const std::string& flag : one.flags) {
      unused.erase(flag);
      EXPECT_TRUE(documented.count(flag) + errata.count(flag) + errata_without_switch.count(flag) > 0)
          << one.id << ": " << flag;
    }
  }
  for (const std::string& flag : unused) ADD_FAILURE() << "no case has the flag " << flag;
}

TEST(Corpus, ShowsEachErratumWhereItSaysSo) {
  for (const cases::Case& one : cases::corpus()) {
    const Judge judge(one.scene, {});
    for (const std::string& flag : one.flags) {
      if (errata.count(flag) == 0) continue;
      const auto as_written = implementations::make_engine("as-written:" + flag)->on(one.scene);
      EXPECT_FALSE(judge.judge(one.ask, as_written->answer(one.ask).answer).is_accepted())
          << one.id << " does not show " << flag;
    }
  }
}

}  // namespace
}  // namespace groundtruth::judge
