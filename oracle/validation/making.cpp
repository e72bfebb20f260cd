#include <groundtruth/validation/making.hpp>

#include <array>
#include <utility>

#include <groundtruth/cases/ask_changes.hpp>
#include <groundtruth/cases/ask_source.hpp>
#include <groundtruth/cases/builtin_scenes.hpp>
#include <groundtruth/cases/random.hpp>
#include <groundtruth/cases/range_changes.hpp>
#include <groundtruth/cases/scene_builders.hpp>
#include <groundtruth/cases/scene_changes.hpp>
#include <groundtruth/cases/small_scenes.hpp>
#include <groundtruth/implementations/engine.hpp>

namespace groundtruth::validation {
namespace {

using cases::Random;
using cases::seed_of_part;

std::uint64_t seed_of_batch(std::uint64_t seed, std::uint64_t strand, std::uint64_t batch) {
  return seed_of_part(seed_of_part(seed, strand), batch);
}

Scene of_pack(std::string_view name, Random& random) {
  std::vector<Scene> pack = cases::find_builtin_scene(name)->build();
  return std::move(pack[random.below(pack.size())]);
}

// Those that people know, as small as they come.
Scene familiar_scene(Random& random) {
  const std::uint64_t seed = random.bits();
  switch (random.below(5)) {
    case 0:
      return cases::house();
    case 1:
      return cases::ramp();
    case 2:
      return cases::runway_of(2 + random.below(6));
    case 3:
      return cases::town_of(1 + random.below(3), seed);
    default:
      return cases::hills_of(1 + random.below(2));
  }
}

// Thousands of leaves: seldom, because an ask about them costs as much as dozens of others.
bool is_large(std::uint64_t strand, std::uint64_t batch) { return batch == 20 && strand % 2 == 0; }

// More leaves than 16 bits count, and more operands than a thousand, every now and then.
Scene large_scene(std::uint64_t number, Random& random) {
  constexpr std::array<std::string_view, 4> large{"runway", "hills", "town", "far-town"};
  const std::uint64_t kind = number % (large.size() + 1);
  return kind < large.size() ? of_pack(large[kind], random) : cases::runway_of(22000);
}

constexpr std::array<cases::AskMix, number_of_kinds> only_of_kind{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

}  // namespace

Scene scene_of_batch(std::uint64_t seed, std::uint64_t strand, std::uint64_t batch) {
  Random random(seed_of_batch(seed, strand, batch));
  if (is_large(strand, batch)) return large_scene(strand / 2, random);
  const std::uint64_t kind = random.below(16);
  if (kind < 1) return of_pack("degenerate", random);
  if (kind < 2) return of_pack("nested", random);
  if (kind < 4) return familiar_scene(random);
  return cases::small_scene(random);
}

class FreshAsks::Sources {
 public:
  Sources(const Scene& scene, std::uint64_t seed)
      : seed_(seed),
        by_kind_{cases::AskSource(scene, seed, only_of_kind[0]),
                 cases::AskSource(scene, seed, only_of_kind[1]),
                 cases::AskSource(scene, seed, only_of_kind[2])} {}

  Ask ask_at(Kind kind, std::uint64_t number) const {
    Ask ask = by_kind_[static_cast<std::size_t>(kind)].ask_at(number).ask;
    Random random(seed_of_part(~seed_, number));
    if (auto* entry = std::get_if<EntryAsk>(&ask); entry != nullptr && random.one_in(3)) {
      *entry = cases::with_range_moved(*entry, random);
    }
    return ask;
  }

 private:
  std::uint64_t seed_;
  std::array<cases::AskSource, number_of_kinds> by_kind_;
};

FreshAsks::FreshAsks(const Scene& scene, std::uint64_t seed, std::uint64_t strand, std::uint64_t batch)
    : sources_(std::make_unique<const Sources>(scene, seed_of_batch(seed, strand, batch))) {}
FreshAsks::~FreshAsks() = default;

Ask FreshAsks::ask_at(Kind kind, std::uint64_t number) const { return sources_->ask_at(kind, number); }

Scene changed_scene(const Scene& scene, const Change& change) {
  if (change.of_scene == 0) return scene;
  Random random(change.of_scene);
  return cases::changed(scene, random);
}

Ask changed_ask(const Ask& ask, const Answer& exact, const Change& change) {
  if (change.of_ask == 0) return ask;
  Random random(change.of_ask);
  if (const auto* clip = std::get_if<ClipAsk>(&ask)) return cases::changed(*clip, random);
  if (const auto* step = std::get_if<StepAsk>(&ask)) return cases::changed(*step, random);
  std::optional<double> entered_at;
  const auto& entry = std::get<EntryAnswer>(exact);
  if (const auto* border = std::get_if<Border>(&entry)) entered_at = border->lambda;
  return cases::changed(std::get<EntryAsk>(ask), entered_at, random);
}

cases::Case make_case(const CaseName& name) {
  Scene scene = scene_of_batch(name.seed, name.strand, name.batch);
  Ask ask = FreshAsks(scene, name.seed, name.strand, name.batch).ask_at(name.kind, name.number);
  const auto exact = implementations::make_engine("exact");
  for (const Change& change : name.changes) {
    const Answer answer = exact->on(scene)->answer(ask).answer;
    scene = changed_scene(scene, change);
    ask = changed_ask(ask, answer, change);
  }
  return {write_case_name(name), std::move(scene), ask, {}, {}};
}

}  // namespace groundtruth::validation
