// Wrong answers are never accepted in the exact profile.

#include <map>

#include <groundtruth/cases/ask_source.hpp>
#include <groundtruth/cases/builtin_scenes.hpp>
#include <groundtruth/cases/corpus.hpp>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "judging.hpp"
#include "wrong_answers.hpp"

namespace groundtruth::judge {
namespace {

// A scene with its judge, and what it takes to make wrong answers about it.
struct Court {
  explicit Court(const Scene& of)
      : scene(of), judge(of, {}), other_orders(of), exact(implementations::make_engine("exact")->on(scene)) {}

  // The first change that goes unnoticed; empty if there is none. Counts what was noticed.
  std::string unnoticed(const Ask& ask, std::map<std::string, int>& noticed) const {
    for (const WrongAnswer& wrong : wrong_answers(scene, ask, exact->answer(ask))) {
      if (!judge.judge(ask, wrong.answer).is_accepted()) {
        ++noticed[wrong.change];
        continue;
      }
      const auto* step = std::get_if<StepAnswer>(&wrong.answer);
      if (step == nullptr || !other_orders.is_right_on_another_leaf(ask, *step)) return wrong.change;
    }
    return "";
  }

  Scene scene;
  Judge judge;
  OtherOrders other_orders;
  std::unique_ptr<const implementations::EngineOnScene> exact;
};

TEST(WrongAnswers, AreRejectedOnTheCorpus) {
  std::map<std::string, int> noticed;
  for (const cases::Case& one : cases::corpus())
    EXPECT_EQ(Court(one.scene).unnoticed(one.ask, noticed), "") << one.id;
  EXPECT_GE(noticed.size(), 30U) << "the corpus meets nearly every kind of mistake";
}

const Court& court(std::size_t index) {
  static const std::vector<std::unique_ptr<Court>> all = [] {
    std::vector<std::unique_ptr<Court>> courts;
    for (const char* name : {"house", "ramp"})
      courts.push_back(std::make_unique<Court>(cases::find_builtin_scene(name)->build().front()));
    for (const char* name : {"degenerate", "nested"}) {
      const auto pack = cases::find_builtin_scene(name)->build();
      for (std::size_t part = 0; part < pack.size(); part += 3)
        courts.push_back(std::make_unique<Court>(pack[part]));
    }
    return courts;
  }();
  return *all[index % all.size()];
}

RC_GTEST_PROP(WrongAnswers, AreRejectedWhateverIsAsked, (std::size_t scene, std::uint64_t seed)) {
  std::map<std::string, int> noticed;
  const cases::AskSource source(court(scene).scene, seed);
  for (std::uint64_t i = 0; i < 8; ++i)
    RC_ASSERT(court(scene).unnoticed(source.ask_at(i).ask, noticed) == std::string());
}

}  // namespace
}  // namespace groundtruth::judge
