// fast_campaign KIND SEED ASKS [SCENE...]: fast against exact on asks of one kind (entry, clip, step), shared
// out over the built-in scenes named, or all; and which stage decided. Exits with 1 on any difference.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/core.h>
#include <groundtruth/cases/ask_source.hpp>
#include <groundtruth/cases/builtin_scenes.hpp>
#include <groundtruth/cases/random.hpp>
#include <groundtruth/exact/clip.hpp>
#include <groundtruth/exact/entry_point.hpp>
#include <groundtruth/exact/step.hpp>
#include <groundtruth/fast/clip_decided.hpp>
#include <groundtruth/fast/decided_entry.hpp>
#include <groundtruth/fast/step_decided.hpp>

namespace groundtruth {
namespace {

constexpr std::array stage_names{"none", "doubles", "quick pairs", "double-double", "exact"};
using Histogram = std::array<std::uint64_t, stage_names.size()>;

struct Tally {
  Histogram decision{}, numbers{};
  std::uint64_t asks = 0;
  std::uint64_t wrong = 0;
};

struct Decided {
  Answer answer;
  fast::Stage decision;
  fast::Stage numbers;
};

class Fast {
 public:
  explicit Fast(const Scene& scene) : scene_(fast::compile(scene)) {}
  Decided operator()(const EntryAsk& ask) const {
    const auto decided = fast::decide_entry(scene_, ask);
    return {decided.answer, std::max(decided.place, decided.material), decided.lambda};
  }
  Decided operator()(const ClipAsk& ask) const {
    const auto decided = fast::decide_clip(ask);
    return {decided.answer, decided.decisions, decided.force};
  }
  Decided operator()(const StepAsk& ask) const {
    const auto decided = fast::decide_step(scene_, ask);
    return {decided.answer, decided.decisions, decided.numbers};
  }

 private:
  fast::Scene scene_;
};

class Exact {
 public:
  explicit Exact(const Scene& scene) : scene_(scene) {}
  Answer operator()(const EntryAsk& ask) const { return exact::entry_point(scene_, ask).answer; }
  Answer operator()(const ClipAsk& ask) const { return exact::clip(ask).answer; }
  Answer operator()(const StepAsk& ask) const { return exact::step(scene_, ask).answer; }

 private:
  exact::Scene scene_;
};

struct Part {
  const Scene& scene;
  std::string name;
  std::uint64_t seed;
  std::uint64_t asks;
};

void run(const Part& part, const cases::AskMix& mix, Tally& tally) {
  const cases::AskSource source(part.scene, part.seed, mix);
  const Fast fast(part.scene);
  const Exact exact(part.scene);
  for (std::uint64_t i = 0; i < part.asks; ++i) {
    const Ask ask = source.ask_at(i).ask;
    const Decided decided = std::visit(fast, ask);
    ++tally.asks;
    ++tally.decision[static_cast<std::size_t>(decided.decision)];
    ++tally.numbers[static_cast<std::size_t>(decided.numbers)];
    if (decided.answer == std::visit(exact, ask)) continue;
    if (++tally.wrong < 4) fmt::print("  differs: {} seed {} ask {}\n", part.name, part.seed, i);
  }
}

void print(std::string_view what, const Histogram& histogram) {
  fmt::print("  {:<9}", what);
  for (std::size_t i = 0; i < histogram.size(); ++i) fmt::print("{:>15} {:>9}", stage_names[i], histogram[i]);
  fmt::print("\n");
}

std::optional<cases::AskMix> mix_of(std::string_view kind) {
  if (kind == "entry") return cases::AskMix{1, 0, 0};
  if (kind == "clip") return cases::AskMix{0, 1, 0};
  if (kind == "step") return cases::AskMix{0, 0, 1};
  return std::nullopt;
}

std::vector<const cases::BuiltinScene*> scenes_named(int count, char** names) {
  std::vector<const cases::BuiltinScene*> scenes;
  for (int i = 0; i < count; ++i) scenes.push_back(cases::find_builtin_scene(names[i]));
  if (count > 0) return scenes;
  for (const auto& builtin : cases::builtin_scenes()) scenes.push_back(&builtin);
  return scenes;
}

std::uint64_t run(const cases::BuiltinScene& builtin, const cases::AskMix& mix, std::uint64_t seed,
                  std::uint64_t asks) {
  const auto pack = builtin.build();
  Tally tally;
  for (std::size_t part = 0; part < pack.size(); ++part) {
    const std::uint64_t share = asks / pack.size() + (part < asks % pack.size() ? 1 : 0);
    run({pack[part], fmt::format("{}:{}", builtin.name, part), cases::seed_of_part(seed, part), share}, mix,
        tally);
  }
  fmt::print("{}: {} asks, {} differ\n", builtin.name, tally.asks, tally.wrong);
  print("decision", tally.decision);
  print("numbers", tally.numbers);
  std::fflush(stdout);
  return tally.wrong;
}

}  // namespace
}  // namespace groundtruth

int main(int count, char** arguments) {
  using namespace groundtruth;
  const auto mix = count < 4 ? std::nullopt : mix_of(arguments[1]);
  if (!mix) {
    fmt::print(stderr, "usage: fast_campaign entry|clip|step SEED ASKS [SCENE...]\n");
    return 2;
  }
  const std::uint64_t seed = std::stoull(arguments[2]), asks = std::stoull(arguments[3]);
  const auto scenes = scenes_named(count - 4, arguments + 4);
  std::uint64_t wrong = 0;
  for (const auto* scene : scenes) {
    if (scene == nullptr) {
      fmt::print(stderr, "fast_campaign: no such built-in scene\n");
      return 2;
    }
  }
  for (const auto* scene : scenes) wrong += run(*scene, *mix, seed, asks / scenes.size());
  return wrong == 0 ? 0 : 1;
}
