#include <gtest/gtest.h>

#include "command.hpp"

namespace groundtruth::implementations::test {
namespace {

TEST(EngineSubject, AnswersLikeItsEngine) {
  const auto exact = subject(engine_subject("exact"));
  EXPECT_EQ(exact->greeting().name, "groundtruth exact");
  const Ask down = EntryAsk{{0, 0, 1}, {0, 0, -3}};
  const auto replies = exact->ask(ground(), {&down, 1});
  EXPECT_EQ(kinds(replies), "a");
  EXPECT_EQ(replies[0].answer, Answer(EntryAnswer(Border{0.5, 0, {0, 0, 1}, {}})));
  EXPECT_EQ(replies[0].evidence.lambda_exact, "1/2");
}

TEST(EngineSubject, RefusesWithAReason) {
  const auto exact = subject(engine_subject("exact"));
  StepAsk landing;
  landing.wheel = {-1e5, -1e5, -1e3, -1e3, 0.2, 0.8, 0.8, "rubber"};
  landing.frame.position_in_world = {0, 0, -0.5};
  landing.frame.world_from_wheel = {0, 1, 0, 0};  // z down
  landing.h = 0.001;
  const Ask ask = landing;
  const auto replies = exact->ask(ground(), {&ask, 1});
  EXPECT_EQ(kinds(replies), "r");
  EXPECT_NE(replies[0].detail.find("has no material"), std::string::npos) << replies[0].detail;
}

TEST(EngineSubject, IsNoneOfAnUnknownName) {
  const SubjectOrNone found = engine_subject("perfect");
  ASSERT_TRUE(std::holds_alternative<NoSubject>(found));
  EXPECT_NE(std::get<NoSubject>(found).problem.find("perfect"), std::string::npos);
}

}  // namespace
}  // namespace groundtruth::implementations::test
