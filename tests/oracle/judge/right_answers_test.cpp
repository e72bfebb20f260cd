// Right answers are never rejected: the exact one, and every other admissible face.

#include <algorithm>
#include <memory>

#include <groundtruth/cases/ask_source.hpp>
#include <groundtruth/cases/builtin_scenes.hpp>
#include <groundtruth/cases/corpus.hpp>

#include <gtest/gtest.h>

#include "judging.hpp"

namespace groundtruth::judge {
namespace {

// The same scene with its operands in reverse: other leaves are canonical there.
Shape reversed(const Shape& shape) {
  Shape result = shape;
  const auto all = [](std::vector<Shape>& operands) {
    for (Shape& operand : operands) operand = reversed(operand);
    std::reverse(operands.begin(), operands.end());
  };
  if (auto* of = std::get_if<Union>(&result.expression)) all(of->operands);
  if (auto* of = std::get_if<Intersection>(&result.expression)) all(of->operands);
  if (auto* of = std::get_if<Covered>(&result.expression))
    of->over = std::make_shared<const Shape>(reversed(*of->over));
  if (auto* of = std::get_if<Painted>(&result.expression))
    of->over = std::make_shared<const Shape>(reversed(*of->over));
  return result;
}

Answer with_leaf_numbers_reversed(Answer answer, std::size_t leaves) {
  if (auto* entry = std::get_if<EntryAnswer>(&answer)) {
    if (auto* border = std::get_if<Border>(entry)) border->leaf = leaves - 1 - border->leaf;
  }
  return answer;
}

void expect_accepted(const Judge& judge, const Ask& ask, const Answer& got, const std::string& name) {
  const Verdict verdict = judge.judge(ask, got);
  EXPECT_TRUE(verdict.is_accepted()) << name << ": " << verdict.explanation;
  EXPECT_EQ(verdict.explanation.empty(), verdict.is_accepted()) << name;
}

void expect_right_answers_accepted(const Scene& scene, const std::vector<Ask>& asks,
                                   const std::string& name) {
  const auto engine = implementations::make_engine("exact");
  const auto exact = engine->on(scene);
  const Shape backwards = reversed(scene.shape);
  const auto other = engine->on({scene.materials, backwards});
  const std::size_t leaves = cases::leaf_count(scene.shape);
  for (const Profile& profile : profiles()) {
    const Judge judge(scene, profile.tolerance);
    for (std::size_t i = 0; i < asks.size(); ++i) {
      const std::string place = name + " ask " + std::to_string(i) + " " + std::string(profile.name);
      expect_accepted(judge, asks[i], exact->answer(asks[i]).answer, place);
      expect_accepted(judge, asks[i], with_leaf_numbers_reversed(other->answer(asks[i]).answer, leaves),
                      place + ", another face");
    }
  }
}

TEST(RightAnswers, AreAcceptedOnTheCorpusInEveryProfile) {
  for (const cases::Case& one : cases::corpus()) expect_right_answers_accepted(one.scene, {one.ask}, one.id);
}

TEST(RightAnswers, AreAcceptedOnBuiltinScenesInEveryProfile) {
  for (const char* name : {"house", "ramp", "degenerate", "nested"}) {
    const auto pack = cases::find_builtin_scene(name)->build();
    for (std::size_t part = 0; part < pack.size(); part += 7) {
      const cases::AskSource source(pack[part], 20261126 + part);
      std::vector<Ask> asks;
      for (std::uint64_t i = 0; i < 60; ++i) asks.push_back(source.ask_at(i).ask);
      expect_right_answers_accepted(pack[part], asks, std::string(name) + ":" + std::to_string(part));
    }
  }
}

TEST(RightAnswers, OfTheFastEngineAreAcceptedExactly) {
  const auto pack = cases::find_builtin_scene("ramp")->build();
  const auto fast = implementations::make_engine("fast")->on(pack[0]);
  const Judge judge(pack[0], {});
  const cases::AskSource source(pack[0], 7);
  for (std::uint64_t i = 0; i < 300; ++i) {
    const Ask ask = source.ask_at(i).ask;
    expect_accepted(judge, ask, fast->answer(ask).answer, "ask " + std::to_string(i));
  }
}

}  // namespace
}  // namespace groundtruth::judge
