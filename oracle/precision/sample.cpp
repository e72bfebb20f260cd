#include <groundtruth/precision/sample.hpp>

#include <algorithm>
#include <array>
#include <memory>

#include <groundtruth/cases/ask_source.hpp>
#include <groundtruth/cases/random.hpp>

namespace groundtruth::precision {
namespace {

using cases::Flavour;

// Of the roots that answers hold: far more than an ulp's share.
constexpr unsigned digits = 60;
// Of a stream, for each ask wanted.
constexpr std::uint64_t patience = 600;

constexpr std::array ordinary_flavours{Flavour::entry_random,  Flavour::entry_strut,    Flavour::clip_random,
                                       Flavour::step_free_hit, Flavour::step_free_miss, Flavour::step_resting,
                                       Flavour::step_skidding, Flavour::step_turning};

Population population_of(const cases::GeneratedAsk& generated) {
  const bool is_ordinary = std::find(ordinary_flavours.begin(), ordinary_flavours.end(), generated.flavour) !=
                           ordinary_flavours.end();
  return is_ordinary && generated.placement == cases::Placement::as_made ? Population::ordinary
                                                                         : Population::hostile;
}

// One scene's asks of a kind and population, one after the other.
class Stream {
 public:
  Stream(const Scene& scene, std::uint64_t seed) : source_(scene, seed) {}

  std::optional<Case> next(const Sample& sample, std::size_t part) {
    for (std::uint64_t tried = 0; tried < patience; ++tried) {
      const std::uint64_t index = index_++;
      cases::GeneratedAsk generated = source_.ask_at(index);
      if (tiers::kind_of(generated.ask) == sample.kind && population_of(generated) == sample.population)
        return Case{part, index, std::move(generated.ask), {}};
    }
    return std::nullopt;
  }

 private:
  cases::AskSource source_;
  std::uint64_t index_ = 0;
};

}  // namespace

std::string_view name_of(Population population) {
  return population == Population::ordinary ? "ordinary" : "hostile";
}

std::string_view name_of(tiers::AskKind kind) {
  constexpr std::array<std::string_view, 3> names{"entry", "clip", "step"};
  return names[static_cast<std::size_t>(kind)];
}

Sample draw(const std::string& scene, const std::vector<Scene>& pack, tiers::AskKind kind,
            Population population, std::uint64_t seed, std::size_t count) {
  Sample sample{scene, kind, population, seed, pack, {}};
  const auto exact = implementations::make_engine("exact", digits);
  for (std::size_t part = 0; part < pack.size(); ++part) {
    const std::size_t wanted = count / pack.size() + (part < count % pack.size() ? 1 : 0);
    if (wanted == 0) continue;
    Stream stream(pack[part], cases::seed_of_part(seed, part));
    const auto on_scene = exact->on(pack[part]);
    for (std::size_t i = 0; i < wanted; ++i) {
      auto found = stream.next(sample, part);
      if (!found) break;
      found->truth = on_scene->answer(found->ask);
      sample.cases.push_back(std::move(*found));
    }
  }
  // Whoever answers only the first few meets all scenes.
  std::stable_sort(sample.cases.begin(), sample.cases.end(),
                   [](const Case& a, const Case& b) { return a.index < b.index; });
  return sample;
}

}  // namespace groundtruth::precision
