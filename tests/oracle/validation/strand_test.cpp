#include <set>

#include <gtest/gtest.h>

#include <groundtruth/implementations/engine.hpp>
#include <groundtruth/text/ask_text.hpp>
#include <groundtruth/text/scene_text.hpp>
#include <groundtruth/validation/making.hpp>
#include <groundtruth/validation/strand.hpp>

namespace groundtruth::validation {
namespace {

// What a right implementation comes to, one an ask; every `wrong_each`th is held to be wrong.
std::vector<Finding> findings_of(const Batch& batch, std::size_t wrong_each) {
  const auto exact = implementations::make_engine("exact")->on(*batch.scene);
  std::vector<Finding> findings(batch.asks.size());
  for (std::size_t i = 0; i < findings.size(); ++i) {
    implementations::Answered answered = exact->answer(batch.asks[i]);
    findings[i].verdict.exact = std::move(answered.answer);
    findings[i].verdict.evidence = std::move(answered.evidence);
    if (wrong_each > 0 && i % wrong_each == 0) findings[i].outcome = Outcome::wrong;
  }
  return findings;
}

std::vector<Batch> all_batches(const StrandPlan& plan, std::size_t wrong_each = 0) {
  std::vector<Batch> batches;
  const auto strand = strand_of(plan);
  while (const auto batch = strand->next()) {
    strand->learn(findings_of(*batch, wrong_each));
    batches.push_back(*batch);
  }
  return batches;
}

std::vector<std::string> ids_of(const std::vector<Batch>& batches) {
  std::vector<std::string> ids;
  for (const Batch& batch : batches) ids.insert(ids.end(), batch.ids.begin(), batch.ids.end());
  return ids;
}

TEST(Strand, GivesAsManyCasesAsPlannedAndNoneTwice) {
  const auto ids = ids_of(all_batches({5, 2, 333, 0, {}}));
  EXPECT_EQ(ids.size(), 333u);
  EXPECT_EQ(std::set<std::string>(ids.begin(), ids.end()).size(), 333u);
}

TEST(Strand, IsTheSameAgain) {
  EXPECT_EQ(ids_of(all_batches({5, 2, 300, 0, {}})), ids_of(all_batches({5, 2, 300, 0, {}})));
  EXPECT_NE(ids_of(all_batches({5, 2, 300, 0, {}})), ids_of(all_batches({5, 3, 300, 0, {}})));
}

TEST(Strand, NamesCasesSoThatTheyCanBeMadeAgain) {
  std::size_t bred = 0;
  for (const Batch& batch : all_batches({7, 1, 400, 0, {}})) {
    for (std::size_t i = 0; i < batch.ids.size(); ++i) {
      const auto name = read_case_name(batch.ids[i]);
      ASSERT_TRUE(name) << batch.ids[i];
      bred += !name->changes.empty();
      const cases::Case made = make_case(*name);
      EXPECT_EQ(write_scene(made.scene), write_scene(*batch.scene)) << batch.ids[i];
      EXPECT_EQ(write_ask("0", made.ask), write_ask("0", batch.asks[i])) << batch.ids[i];
    }
  }
  EXPECT_GT(bred, 50u) << "what is new breeds";
}

TEST(Strand, AsksOnlyTheKindsThatHaveAShare) {
  for (const Batch& batch : all_batches({5, 2, 200, 0, {0, 1, 0}})) {
    for (const Ask& ask : batch.asks) EXPECT_EQ(kind_of_ask(ask), Kind::clip);
  }
}

TEST(Strand, EndsWhenItHasFailedEnough) {
  EXPECT_LT(ids_of(all_batches({5, 2, 300, 4, {}}, 3)).size(), 50u);
  EXPECT_EQ(ids_of(all_batches({5, 2, 300, 0, {}}, 3)).size(), 300u);
}

// As texts they come back the same: so they are finite, and keep what each kind of ask requires.
TEST(Strand, AsksWhatCanBeWrittenAndRead) {
  for (std::uint64_t number = 0; number < 6; ++number) {
    for (const Batch& batch : all_batches({11, number, 300, 0, {}}, 4)) {
      const std::string scene = write_scene(*batch.scene);
      ASSERT_EQ(write_scene(read_scene(scene, {"scene"})), scene);
      for (const Ask& ask : batch.asks) {
        const std::string line = write_ask("0", ask);
        const Line read = read_line(line, {"ask"});
        ASSERT_TRUE(std::holds_alternative<AskLine>(read)) << line;
        ASSERT_EQ(write_ask("0", std::get<AskLine>(read).ask), line);
      }
    }
  }
}

}  // namespace
}  // namespace groundtruth::validation
