#include <gtest/gtest.h>

#include <groundtruth/cases/corpus.hpp>
#include <groundtruth/text/ask_text.hpp>
#include <groundtruth/text/scene_text.hpp>
#include <groundtruth/validation/conclusion.hpp>
#include <groundtruth/validation/known_failures.hpp>

namespace groundtruth::validation {
namespace {

Failure some_failure() {
  Failure failure;
  failure.asked = cases::corpus().front();
  failure.finding.outcome = Outcome::wrong;
  failure.finding.verdict.difference = judge::Difference::face;
  failure.finding.verdict.explanation = "leaf 3 -> leaf 5, \"quoted\"";
  failure.finding.reply.text = "{\"id\":\"a1\",\"answer\":{\"kind\":\"miss\"}}";
  failure.finding.verdict.exact = EntryAnswer{Miss{}};
  return failure;
}

Record record_with(Outcome outcome, Expectation expectation) {
  Record record;
  record.outcome = outcome;
  record.expectation = expectation;
  return record;
}

TEST(Record, ReadsBackAsWritten) {
  const Record record = record_of(some_failure());
  const std::string line = write_record(record);
  const Record read = read_record(line, {"file"});
  EXPECT_EQ(read.got, record.got);
  EXPECT_EQ(read.exact, record.exact);
  EXPECT_EQ(read.explanation, record.explanation);
  EXPECT_EQ(read.difference, "face");
  EXPECT_EQ(read.outcome, Outcome::wrong);
  const cases::Case asked = case_of(read, {"file"});
  EXPECT_EQ(asked.id, some_failure().asked.id);
  EXPECT_EQ(write_scene(asked.scene), write_scene(some_failure().asked.scene));
  EXPECT_EQ(write_ask("0", asked.ask), write_ask("0", some_failure().asked.ask));
}

TEST(Record, KeepsALineThatIsNoJsonAsText) {
  Failure failure = some_failure();
  failure.finding.outcome = Outcome::unreadable;
  failure.finding.reply.text = "what? \"this\"";
  EXPECT_EQ(record_of(failure).got, R"("what? \"this\"")");
  EXPECT_NO_THROW(read_record(write_record(record_of(failure)), {"file"}));
}

TEST(Record, NamesFileLineAndFieldOfWhatItCannotRead) {
  try {
    read_record(R"({"case": 7})", {"failures.jsonl", 12});
    FAIL() << "a case that is no string";
  } catch (const BadInput& bad) {
    EXPECT_STREQ(bad.what(), "failures.jsonl:12: case: no string");
  }
}

TEST(KnownFailures, TellsKnownFromChangedFromUnexpected) {
  const Record record = record_of(some_failure());
  const KnownFailures known({record});
  EXPECT_EQ(known.expectation_of(record), Expectation::known);
  Record other = record;
  other.difference = "material";
  EXPECT_EQ(known.expectation_of(other), Expectation::changed);
  other = record;
  other.outcome = Outcome::crashed;
  EXPECT_EQ(known.expectation_of(other), Expectation::changed);
  other.id = "another";
  EXPECT_EQ(known.expectation_of(other), Expectation::unexpected);
}

TEST(Conclusion, TakesTheFirstThatHolds) {
  Tally some;
  some.add(Kind::clip, Outcome::accepted);
  const Record wrong = record_with(Outcome::wrong, Expectation::none);
  const Record crashed = record_with(Outcome::crashed, Expectation::none);
  const Record unreadable = record_with(Outcome::unreadable, Expectation::none);
  EXPECT_EQ(conclude(some, {unreadable, crashed, wrong}), Conclusion::disagrees);
  EXPECT_EQ(conclude(some, {unreadable, crashed}), Conclusion::broke_down);
  EXPECT_EQ(conclude(some, {unreadable}), Conclusion::unreadable);
  EXPECT_EQ(conclude(some, {}), Conclusion::agrees);
  EXPECT_EQ(conclude({}, {}), Conclusion::nothing_judged);
}

TEST(Conclusion, ForgivesKnownFailuresButNotThatTheyPassOrChange) {
  Tally some;
  some.add(Kind::clip, Outcome::accepted);
  EXPECT_EQ(conclude(some, {record_with(Outcome::wrong, Expectation::known)}), Conclusion::agrees);
  EXPECT_EQ(conclude(some, {record_with(Outcome::crashed, Expectation::changed)}), Conclusion::disagrees);
  EXPECT_EQ(conclude(some, {record_with(Outcome::accepted, Expectation::passes)}), Conclusion::disagrees);
}

}  // namespace
}  // namespace groundtruth::validation
