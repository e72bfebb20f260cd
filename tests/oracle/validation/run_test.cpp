#include <set>

#include <gtest/gtest.h>

#include <groundtruth/cases/corpus.hpp>
#include <groundtruth/validation/course.hpp>

namespace groundtruth::validation {
namespace {

using implementations::Reply;
using implementations::ReplyKind;

// Right but for what a test makes of some of its replies.
class Fake : public implementations::Subject {
 public:
  using Spoil = std::function<void(const Ask&, Reply&)>;
  explicit Fake(Spoil spoil) : spoil_(std::move(spoil)) {}

  const implementations::Greeting& greeting() const override { return greeting_; }
  std::string last_words() const override { return {}; }
  std::vector<Reply> ask(const Scene& scene, std::span<const Ask> asks) override {
    std::vector<Reply> replies = exact_->ask(scene, asks);
    for (std::size_t i = 0; i < asks.size(); ++i) spoil_(asks[i], replies[i]);
    return replies;
  }

 private:
  Spoil spoil_;
  implementations::Greeting greeting_{"fake"};
  std::unique_ptr<implementations::Subject> exact_ = std::get<0>(implementations::engine_subject("exact"));
};

Result run_on(const Fake::Spoil& spoil, const Selection& selection, const RunPlan& plan = {}) {
  return run(plan, course_of(selection), [&] { return std::make_unique<Fake>(spoil); }, {});
}

Selection of_cases(std::uint64_t cases) {
  Selection selection;
  selection.cases = cases;
  return selection;
}

std::set<std::string> ids_of(const Result& result) {
  std::set<std::string> ids;
  for (const Failure& failure : result.failures) ids.insert(failure.asked.id);
  return ids;
}

void spoil_nothing(const Ask&, Reply&) {}

// Says that it hits what it misses.
void spoil_misses(const Ask&, Reply& reply) {
  auto* entry = std::get_if<EntryAnswer>(&reply.answer);
  if (entry != nullptr && std::holds_alternative<Miss>(*entry)) *entry = Inside{0};
}

TEST(Run, JudgesAllCasesOfCorpusAndStrands) {
  const std::uint64_t corpus = cases::corpus().size();
  const Result result = run_on(spoil_nothing, of_cases(corpus + 1500));
  EXPECT_EQ(result.tally.judged(), corpus + 1500);
  EXPECT_EQ(result.tally.count(Outcome::accepted), corpus + 1500);
  EXPECT_EQ(result.ending, Ending::all_asked);
  EXPECT_EQ(run_on(spoil_nothing, of_cases(3)).tally.judged(), 3u);
}

TEST(Run, FindsTheSameFailuresWithAnyNumberOfJobs) {
  RunPlan many;
  many.jobs = 4;
  const Result one = run_on(spoil_misses, of_cases(3000));
  const Result four = run_on(spoil_misses, of_cases(3000), many);
  EXPECT_GT(one.failures.size(), 10u);
  EXPECT_EQ(ids_of(one), ids_of(four));
}

TEST(Run, SaysWhetherTheRestWasLeftOutAsEnoughHadFailed) {
  Selection selection = of_cases(3000);
  selection.most_failures = 5;
  const Result few = run_on(spoil_misses, selection);
  EXPECT_EQ(few.ending, Ending::enough_failed);
  EXPECT_LT(few.tally.judged(), 3000u);
  selection.most_failures = 0;
  EXPECT_EQ(run_on(spoil_misses, selection).ending, Ending::all_asked);
}

TEST(Run, IsTheSumOfItsShards) {
  const Result whole = run_on(spoil_misses, of_cases(4000));
  Tally tally;
  std::set<std::string> ids;
  for (std::uint64_t index = 1; index <= 3; ++index) {
    Selection selection = of_cases(4000);
    selection.shard = {index, 3};
    const Result part = run_on(spoil_misses, selection);
    tally.merge(part.tally);
    for (const std::string& id : ids_of(part))
      EXPECT_TRUE(ids.insert(id).second) << id << " is in two shards";
  }
  EXPECT_EQ(tally.judged(), whole.tally.judged());
  EXPECT_EQ(ids, ids_of(whole));
}

TEST(Run, SaysOfEachReplyWhatItIs) {
  const std::pair<ReplyKind, Outcome> kinds[] = {{ReplyKind::crashed, Outcome::crashed},
                                                 {ReplyKind::hung, Outcome::hung},
                                                 {ReplyKind::unreadable, Outcome::unreadable},
                                                 {ReplyKind::refused, Outcome::wrong}};
  for (const auto& [kind, outcome] : kinds) {
    const auto spoil = [kind = kind](const Ask& ask, Reply& reply) {
      if (std::holds_alternative<EntryAsk>(ask)) reply = {kind, {}, {}, {}, "because"};
    };
    const Result result = run_on(spoil, of_cases(12));
    ASSERT_FALSE(result.failures.empty());
    for (const Failure& failure : result.failures) EXPECT_EQ(failure.finding.outcome, outcome);
    EXPECT_EQ(result.tally.count(outcome), result.failures.size());
  }
}

TEST(Run, SkipsTheKindsThatAreNotJudged) {
  RunPlan plan;
  plan.kinds = {false, true, true};
  const Result result = run_on(spoil_misses, of_cases(cases::corpus().size()), plan);
  EXPECT_GT(result.tally.count(Kind::entry, Outcome::skipped), 0u);
  EXPECT_EQ(result.tally.judged(Kind::entry), 0u);
  EXPECT_TRUE(result.failures.empty());
}

TEST(Run, EndsWhenInterrupted) {
  std::atomic<bool> interrupted = false;
  Watch watch;
  watch.interrupted = &interrupted;
  watch.judged = [&](std::uint64_t judged) { interrupted = judged > 300; };
  Selection endless;
  const Result result = run(
      {}, course_of(endless), [] { return std::make_unique<Fake>(spoil_nothing); }, watch);
  EXPECT_EQ(result.ending, Ending::interrupted);
  EXPECT_LT(result.tally.judged(), 400u);
}

TEST(Run, EndsWhenTooManyHang) {
  const auto hang = [](const Ask&, Reply& reply) { reply = {ReplyKind::hung, {}, {}, {}, "nothing came"}; };
  const Result result = run_on(hang, of_cases(2000));
  EXPECT_EQ(result.ending, Ending::too_many_hung);
  EXPECT_LT(result.tally.judged(), 100u);
}

}  // namespace
}  // namespace groundtruth::validation
