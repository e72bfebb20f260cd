#include <gtest/gtest.h>

#include "command.hpp"

namespace groundtruth::implementations::test {
namespace {

std::string problem_with(const std::string& library) {
  const SubjectOrNone found = load_library(library, short_patience);
  const auto* none = std::get_if<NoSubject>(&found);
  return none == nullptr ? "" : none->problem;
}

TEST(LibrarySubject, IsNoneWithoutALibrary) {
  EXPECT_NE(problem_with("/nowhere/library.so").find("/nowhere/library.so"), std::string::npos);
}

TEST(LibrarySubject, IsNoneWithoutTheFunction) {
  EXPECT_NE(problem_with("libm.so.6").find("groundtruth_answer"), std::string::npos);
}

TEST(LibrarySubject, AnswersAndItsCrashIsAVerdict) {
  const auto library = subject(load_library(HOSTILE_LIBRARY, short_patience));
  EXPECT_EQ(library->greeting().name, "c");
  EXPECT_TRUE(library->greeting().entry);
  EXPECT_FALSE(library->greeting().step);
  const auto replies = library->ask(ground(), asks(6, 2));
  EXPECT_EQ(kinds(replies), "aacaaa");
  EXPECT_NE(replies[2].detail.find("signal 6"), std::string::npos) << replies[2].detail;
}

TEST(LibrarySubject, TakesNothingThatIsPrintedForAnAnswer) {
  const auto library = subject(load_library(HOSTILE_LIBRARY, short_patience));
  const auto replies = library->ask(ground(), asks(1, 1));
  EXPECT_EQ(replies[0].answer, Answer(EntryAnswer(Miss{})));
  EXPECT_NE(library->last_words().find("inside"), std::string::npos);
}

}  // namespace
}  // namespace groundtruth::implementations::test
