// Each planted mistake shows in its witness, and the right ones have none.

#include <fstream>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include <groundtruth/cases/ask_source.hpp>
#include <groundtruth/cases/builtin_scenes.hpp>
#include <groundtruth/judge/verdict.hpp>
#include <groundtruth/text/answer_text.hpp>
#include <groundtruth/text/ask_text.hpp>

#include "planted_engine.hpp"

namespace groundtruth::planted {
namespace {

struct Witness {
  std::string name;
  Scene scene;
  Ask ask;
};

// Lines of scenes and asks, an ask's id being the mistake that it shows.
std::vector<Witness> read_witnesses() {
  std::ifstream file(GROUNDTRUTH_WITNESSES);
  std::vector<Witness> witnesses;
  Scene scene;
  std::size_t number = 0;
  for (std::string text; std::getline(file, text);) {
    Line line = read_line(text, {GROUNDTRUTH_WITNESSES, ++number});
    if (auto* scene_line = std::get_if<SceneLine>(&line)) scene = std::move(scene_line->scene);
    if (auto* ask = std::get_if<AskLine>(&line)) {
      witnesses.push_back({ask->id.substr(1, ask->id.size() - 2), scene, ask->ask});
    }
  }
  return witnesses;
}

TEST(PlantedBugs, HaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (const Bug& bug : all_bugs()) EXPECT_TRUE(names.insert(bug.name).second) << bug.name;
  EXPECT_GE(names.size(), 60U);
}

TEST(PlantedBugs, AreWrongAboutTheirWitnesses) {
  std::set<std::string_view> unseen;
  for (const Bug& bug : all_bugs()) unseen.insert(bug.name);
  for (const auto& [name, scene, ask] : read_witnesses()) {
    const judge::Judge judge(scene, {});
    for (const Bug& bug : all_bugs()) {
      if (bug.name != name) continue;
      unseen.erase(bug.name);
      EXPECT_EQ(static_cast<Kind>(ask.index()), bug.kind) << name;
      EXPECT_FALSE(judge.judge(ask, bug.on(scene)(ask)).is_accepted()) << name;
    }
  }
  for (const std::string_view name : unseen) ADD_FAILURE() << name << " has no witness";
}

TEST(RightOnes, AreRightAboutAThousandAsks) {
  const Scene scene = cases::find_builtin_scene("ramp")->build().front();
  const judge::Judge judge(scene, {});
  for (const RightOne& one : right_ones()) {
    const Answering planted = one.on(scene);
    cases::AskSource source(scene, 1);
    for (int i = 0; i < 1000; ++i) {
      const Ask ask = source.next().ask;
      const std::string line = one.rephrase(write_answer("1", planted(ask), {}, scene));
      const AnswerLine read = read_answer(line, ask, scene, {std::string(one.name), 1});
      const auto* answer = std::get_if<Answer>(&read.answer);
      const Answer refused{StepAnswer{Refusal{}}};
      const judge::Verdict verdict = judge.judge(ask, answer == nullptr ? refused : *answer);
      EXPECT_TRUE(verdict.is_accepted()) << one.name << " " << write_ask("1", ask) << verdict.explanation;
    }
  }
}

}  // namespace
}  // namespace groundtruth::planted
