#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <thread>

#include "command.hpp"

namespace groundtruth::implementations::test {
namespace {

std::string problem_with(const std::vector<std::string>& command) {
  const SubjectOrNone found = run_command(command, short_patience);
  const auto* none = std::get_if<NoSubject>(&found);
  return none == nullptr ? "" : none->problem;
}

TEST(CommandSubject, IsNoneOfAProgramThatIsNotThere) {
  EXPECT_EQ(problem_with({"no-such-program"}), "no-such-program: No such file or directory");
  EXPECT_EQ(problem_with({"/etc/passwd"}), "/etc/passwd: Permission denied");
  EXPECT_EQ(problem_with({}), "no command is given");
}

TEST(CommandSubject, IsNoneOfAnotherProtocol) {
  EXPECT_EQ(problem_with(hostile("claims-other-version")), "it speaks answers/9, not answers/1");
}

TEST(CommandSubject, IsFoundOnThePath) {
  const auto shell = subject(run_command({"sh", "-c", "exec \"$0\" none", HOSTILE_PROGRAM}, short_patience));
  EXPECT_EQ(shell->greeting().name, "hostile");
  EXPECT_EQ(kinds(shell->ask(ground(), asks(2, 2))), "aa");
}

TEST(CommandSubject, KnowsTheKindsThatAreClaimed) {
  const auto liar = subject(run_command(hostile("claims-unknown-kinds"), short_patience));
  EXPECT_EQ(liar->greeting().name, "liar");
  EXPECT_TRUE(liar->greeting().entry);
  EXPECT_FALSE(liar->greeting().clip);
  EXPECT_FALSE(liar->greeting().step);
}

TEST(CommandSubject, TakesWhoeverKnowsNoHelloForAllKinds) {
  const auto unknown = subject(run_command(hostile("knows-no-hello"), short_patience));
  EXPECT_EQ(unknown->greeting().name, "");
  EXPECT_TRUE(unknown->greeting().entry && unknown->greeting().clip && unknown->greeting().step);
}

TEST(CommandSubject, KeepsAHugeNameShort) {
  const auto boaster = subject(run_command(hostile("has-huge-name"), short_patience));
  EXPECT_LT(boaster->greeting().name.size(), 300U);
}

TEST(CommandSubject, WritesAndReadsManyAsksWithoutBlockingEitherWay) {
  constexpr std::size_t many = 20000;
  const auto quick = subject(run_command(hostile("none"), short_patience));
  EXPECT_EQ(kinds(quick->ask(ground(), asks(many, many))), std::string(many, 'a'));
}

TEST(CommandSubject, SetsTheSceneAgainAfterACrash) {
  const std::vector<std::string> exact = {GROUNDTRUTH_PROGRAM, "answer"};
  const auto engine = subject(run_command(exact, {std::chrono::seconds(20), std::chrono::seconds(20)}));
  const Ask down = EntryAsk{{0, 0, 1}, {0, 0, -3}};
  const Scene higher{{}, {HalfSpace{{0, 0, 1}, 0}}};
  const Answer at_half = EntryAnswer(Border{0.5, 0, {0, 0, 1}, {}});
  const Answer at_quarter = EntryAnswer(Border{0.25, 0, {0, 0, 1}, {}});
  EXPECT_EQ(engine->ask(ground(), {&down, 1})[0].answer, at_half);
  EXPECT_EQ(engine->ask(higher, {&down, 1})[0].answer, at_quarter);
  EXPECT_EQ(engine->ask(higher, {&down, 1})[0].answer, at_quarter);
  EXPECT_EQ(engine->ask(ground(), {&down, 1})[0].evidence.lambda_exact, "1/2");
}

TEST(CommandSubject, GivesEveryAskAReplyWhenItHasGivenUp) {
  const auto dead = subject(run_command(hostile("exits-at-once"), short_patience));
  const auto replies = dead->ask(ground(), asks(100, 100));
  EXPECT_EQ(kinds(replies), std::string(100, 'c'));
  EXPECT_NE(replies.back().detail.find("not asked"), std::string::npos) << replies.back().detail;
  EXPECT_EQ(dead->ask(ground(), asks(1, 1))[0].detail, "exited with code 3");
}

TEST(CommandSubject, SaysThatAnAskCrashesOnlyInCompany) {
  const auto moody = subject(run_command(hostile("crashes-in-batches"), short_patience));
  EXPECT_NE(moody->ask(ground(), asks(6, 6))[0].detail.find("not when they are asked one by one"),
            std::string::npos);
  EXPECT_EQ(kinds(moody->ask(ground(), asks(1, 1))), "a");
}

TEST(CommandSubject, KeepsTheEndOfWhatIsWrittenToStandardError) {
  const auto shell = subject(run_command({"sh", "-c", "echo woe is me >&2; exit 1"}, short_patience));
  shell->ask(ground(), asks(1, 1));
  EXPECT_NE(shell->last_words().find("woe is me"), std::string::npos);
}

TEST(CommandSubject, AnswersInSeveralThreadsAtOnce) {
  std::vector<std::string> kinds_of(4);
  std::vector<std::thread> threads;
  for (std::string& kinds_here : kinds_of) {
    threads.emplace_back([&kinds_here] {
      const auto own = subject(run_command(hostile("crashes-at-poison"), short_patience));
      kinds_here = kinds(own->ask(ground(), asks(6, 2)));
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(kinds_of, std::vector<std::string>(4, "aacaaa"));
  EXPECT_TRUE(processes_left().empty());
}

// Of a harness that is killed itself nothing is left either.
TEST(CommandSubject, LeavesNothingWhenThisProcessIsKilled) {
  const auto command = hostile("leaves-daemons");
  const pid_t harness = fork();
  if (harness == 0) {
    const auto own = subject(run_command(command, short_patience));
    own->ask(ground(), asks(3, 3));
    raise(SIGKILL);
  }
  waitpid(harness, nullptr, 0);
  for (int i = 0; i < 200 && !processes_left().empty(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_EQ(processes_left(), std::vector<std::string>{});
}

}  // namespace
}  // namespace groundtruth::implementations::test
