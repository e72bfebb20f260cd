// What strangers copy answers rightly itself, by every way in.

#include <gtest/gtest.h>

#include "command.hpp"

namespace groundtruth::implementations::test {
namespace {

constexpr Patience patience{std::chrono::seconds(20), std::chrono::seconds(20)};

Shape box(const Vector& low, const Vector& high) {
  Intersection faces;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Vector normal{};
    normal[axis] = -1;
    faces.operands.push_back({HalfSpace{normal, -low[axis]}});
    normal[axis] = 1;
    faces.operands.push_back({HalfSpace{normal, high[axis]}});
  }
  return {faces};
}

// Two steps of a stair and, beside them, what can be written without a half-space.
Scene stair() { return {{}, {Union{{box({0, 0, 0}, {2, 2, 2}), box({2, 0, 0}, {4, 2, 1}), {Nothing{}}}}}}; }

// Their answers are doubles without any rounding.
std::vector<Ask> asks_of_stair() {
  return {EntryAsk{{1, 1, 4}, {1, 1, -4}},           EntryAsk{{3, 1, 4}, {3, 1, -4}},
          EntryAsk{{-4, 1, 1.5}, {4, 1, 1.5}},       EntryAsk{{8, 1, 1.5}, {-8, 1, 1.5}},
          EntryAsk{{8, 1, 0.5}, {-8, 1, 0.5}},       EntryAsk{{1, 1, 1}, {1, 1, 5}},
          EntryAsk{{5, 5, 5}, {5, 5, -5}},           EntryAsk{{1, 1, 4}, {1, 1, -4}, 0.375, 1},
          EntryAsk{{1, 1, 4}, {1, 1, -4}, 0, 0.125}, EntryAsk{{-1, 1, 1}, {7, 1, 1}, 0.75, 1}};
}

void expect_right(const SubjectOrNone& found, const std::string& name) {
  ASSERT_TRUE(std::holds_alternative<std::unique_ptr<Subject>>(found)) << std::get<NoSubject>(found).problem;
  Subject& implementation = *std::get<std::unique_ptr<Subject>>(found);
  EXPECT_EQ(implementation.greeting().name, name);
  EXPECT_TRUE(implementation.greeting().entry);
  EXPECT_FALSE(implementation.greeting().clip);
  EXPECT_FALSE(implementation.greeting().step);
  const std::vector<Ask> all = asks_of_stair();
  const auto replies = implementation.ask(stair(), all);
  const auto exact = subject(engine_subject("exact"))->ask(stair(), all);
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(replies[i].kind, ReplyKind::answered) << i << ": " << replies[i].detail;
    EXPECT_EQ(replies[i].answer, exact[i].answer) << i << ": " << replies[i].text;
  }
}

std::string file(const std::string& name) { return std::string(TEMPLATES) + "/" + name; }

TEST(Template, InCppIsRightAsAProgram) {
  expect_right(run_command({TEMPLATE_PROGRAM}, patience), "template.cpp");
}

TEST(Template, InCppIsRightAsALibrary) {
  expect_right(load_library(TEMPLATE_LIBRARY, patience), "template.cpp");
}

TEST(Template, InPythonIsRight) {
  expect_right(run_command({PYTHON_PROGRAM, file("template.py")}, patience), "template.py");
}

TEST(Template, InJavaScriptIsRight) {
  expect_right(run_command({NODE_PROGRAM, file("template.js")}, patience), "template.js");
}

}  // namespace
}  // namespace groundtruth::implementations::test
