// Each planted mistake shows in its witness, and the right ones have none.

#include <fstream>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include <groundtruth/cases/ask_source.hpp>
#include <groundtruth/cases/builtin_scenes.hpp>
#include <groundtruth/text/answer_text.hpp>
#include <groundtruth/text/ask_text.hpp>

#include "acceptable.hpp"
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
  const auto exact = implementations::make_engine("exact");
  std::set<std::string_view> unseen;
  for (const Bug& bug : all_bugs()) unseen.insert(bug.name);
  for (const auto& [name, scene, ask] : read_witnesses()) {
    const Right right(scene);
    for (const Bug& bug : all_bugs()) {
      if (bug.name != name) continue;
      unseen.erase(bug.name);
      EXPECT_EQ(static_cast<Kind>(ask.index()), bug.kind) << name;
      EXPECT_FALSE(is_acceptable(bug.on(scene)(ask), exact->on(scene)->answer(ask), ask, right)) << name;
    }
  }
  for (const std::string_view name : unseen) ADD_FAILURE() << name << " has no witness";
}

TEST(RightOnes, AreRightAboutAThousandAsks) {
  const Scene scene = cases::find_builtin_scene("ramp")->build().front();
  const auto exact = implementations::make_engine("exact")->on(scene);
  const Right right(scene);
  for (const RightOne& one : right_ones()) {
    const Answering planted = one.on(scene);
    cases::AskSource source(scene, 1);
    for (int i = 0; i < 1000; ++i) {
      const Ask ask = source.next().ask;
      const std::string line = one.rephrase(write_answer("1", planted(ask), {}, scene));
      const AnswerLine read = read_answer(line, ask, scene, {std::string(one.name), 1});
      const implementations::Answered expected = exact->answer(ask);
      const auto* answer = std::get_if<Answer>(&read.answer);
      if (answer == nullptr) {
        const std::string told = write_answer("1", expected.answer, {}, scene);
        EXPECT_NE(told.find("\"error\""), std::string::npos) << write_ask("1", ask);
        continue;
      }
      EXPECT_TRUE(is_acceptable(*answer, expected, ask, right)) << write_ask("1", ask);
    }
  }
}

}  // namespace
}  // namespace groundtruth::planted
