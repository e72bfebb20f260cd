#include <gtest/gtest.h>

#include "slipping.hpp"
#include "witnessing.hpp"

namespace groundtruth::diagnosis {
namespace {

const Asking& asking() {
  static const Asking asking(20);
  return asking;
}

std::optional<Diagnosis> diagnosis_of(const implementations::Engine& subject) {
  const Judged judged = asking().judge(subject);
  return diagnose(judged.failures, judged.accepted);
}

TEST(Diagnose, NamesEachErratum) {
  for (const Suspect& erratum : errata()) {
    const auto diagnosis = diagnosis_of(*engine_of(erratum));
    EXPECT_TRUE(names(diagnosis, erratum.name)) << erratum.name << ": " << told(diagnosis);
  }
}

TEST(Diagnose, NamesPairsOfErrata) {
  const std::vector<Suspect> pairs = pairs_of_errata();
  for (std::size_t i = 0; i < pairs.size(); i += 12) {
    const auto diagnosis = diagnosis_of(*engine_of(pairs[i]));
    EXPECT_TRUE(names(diagnosis, pairs[i].name)) << pairs[i].name << ": " << told(diagnosis);
  }
}

TEST(Diagnose, NamesEachSlip) {
  for (const Suspect& slip : classic_slips()) {
    const auto diagnosis = diagnosis_of(*engine_of(slip));
    EXPECT_TRUE(names(diagnosis, slip.name)) << slip.name << ": " << told(diagnosis);
  }
}

TEST(Diagnose, AccusesNobodyOfWhatNothingExplains) {
  Suspect odd{"odd", "each entry is a little early",
              [](const Scene& scene, const Ask& ask) {
                Answer answer = implementations::make_engine("exact")->on(scene)->answer(ask).answer;
                if (auto* entry = std::get_if<EntryAnswer>(&answer))
                  if (auto* border = std::get_if<Border>(entry)) border->lambda -= 0.001953125;
                return answer;
              },
              Trace::own_error};
  EXPECT_EQ(told(diagnosis_of(*engine_of(odd))), "-");
}

TEST(Diagnose, AccusesNobodyWithoutFailures) { EXPECT_FALSE(diagnose({}, {})); }

}  // namespace
}  // namespace groundtruth::diagnosis
