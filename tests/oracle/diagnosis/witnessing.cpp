#include "witnessing.hpp"

#include <algorithm>

#include <groundtruth/cases/ask_source.hpp>
#include <groundtruth/cases/builtin_scenes.hpp>
#include <groundtruth/cases/corpus.hpp>
#include <groundtruth/cases/shape_parts.hpp>
#include <groundtruth/judge/finite.hpp>

namespace groundtruth::diagnosis {
namespace {

// Where 1000 m more than the end of the range is the end of the range.
std::vector<cases::Case> asks_beyond_large_ends(const Scene& scene) {
  std::vector<cases::Case> asks;
  for (const double end : {0x1p63, 0x1p65, 0x1p80, 0x1p300})
    for (const double first : {0.0, 1.0, end / 2})
      for (const Vector& to : {Vector{0, 0, 60}, Vector{1, 0, 50}, Vector{0, 1, 51}})
        asks.push_back({"", scene, EntryAsk{{0, 0, 50}, to, first, end}, {}, ""});
  return asks;
}

std::vector<cases::Case> generated(const Scene& scene, std::size_t count) {
  std::vector<cases::Case> asks;
  cases::AskSource source(scene, 1);
  for (std::size_t i = 0; i < count; ++i) asks.push_back({"", scene, source.next().ask, {}, ""});
  return asks;
}

}  // namespace

Asking::OfScene::OfScene(const Scene& of, std::vector<cases::Case> asks)
    : scene(of), judge(of, judge::profiles().front().tolerance) {
  const auto exact = implementations::make_engine("exact")->on(scene);
  for (cases::Case& one : asks) {
    Answer answer = exact->answer(one.ask).answer;
    asked.push_back({std::move(one), std::move(answer)});
  }
}

Asking::Asking(std::size_t asks_a_scene) {
  for (const cases::Case& one : cases::corpus()) scenes_.emplace_back(one.scene, std::vector{one});
  for (const cases::BuiltinScene& builtin : cases::builtin_scenes()) {
    for (const Scene& scene : builtin.build()) {
      if (cases::leaf_count(scene.shape) > 200) continue;
      std::vector<cases::Case> asks = generated(scene, asks_a_scene);
      std::ranges::move(asks_beyond_large_ends(scene), std::back_inserter(asks));
      scenes_.emplace_back(scene, std::move(asks));
    }
  }
}

Judged Asking::judge(const implementations::Engine& subject) const {
  Judged judged;
  for (const OfScene& part : scenes_) {
    const auto on_scene = subject.on(part.scene);
    for (const Asked& one : part.asked) {
      const Answer got = on_scene->answer(one.asked.ask).answer;
      // The pipe would not let another answer through to the judge.
      if (!judge::has_only_finite_numbers(got)) continue;
      // The judge takes its time, and most are the same bits.
      const bool is_accepted = got == one.exact || part.judge.judge(one.asked.ask, got).is_accepted();
      (is_accepted ? judged.accepted : judged.failures).push_back({one.asked, got, one.exact});
    }
  }
  return judged;
}

std::string told(const std::optional<Diagnosis>& diagnosis) {
  if (!diagnosis) return "-";
  std::string text = diagnosis->name;
  for (const std::string& equal : diagnosis->equals) text += " = " + equal;
  return text;
}

bool names(const std::optional<Diagnosis>& diagnosis, const std::string& name) {
  return diagnosis && (diagnosis->name == name || std::ranges::count(diagnosis->equals, name) > 0);
}

}  // namespace groundtruth::diagnosis
