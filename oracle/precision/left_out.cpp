#include <groundtruth/precision/left_out.hpp>

#include <algorithm>
#include <memory>

#include <groundtruth/implementations/compilation.hpp>
#include <groundtruth/precision/clock.hpp>

namespace groundtruth::precision {
namespace {

using implementations::EngineOnScene;

// The pack compiled in one way, and its times.
struct Way {
  std::vector<std::unique_ptr<const EngineOnScene>> on_scenes;
  std::vector<Answer> answers;
  std::vector<double> nanoseconds;
};

Way compiled_without(const std::vector<std::string>& names, const Sample& sample) {
  Way way;
  for (const Scene& scene : sample.pack) way.on_scenes.push_back(implementations::fast_without(scene, names));
  for (const Case& one : sample.cases) way.answers.push_back(way.on_scenes[one.part]->answer(one.ask).answer);
  return way;
}

void take_time(Way& way, const Sample& sample) {
  for (const Case& one : sample.cases) way.on_scenes[one.part]->answer(one.ask);  // fills the caches
  const double start = thread_seconds();
  for (std::size_t i = 0; i < sample.cases.size(); ++i)
    way.answers[i] = way.on_scenes[sample.cases[i].part]->answer(sample.cases[i].ask).answer;
  way.nanoseconds.push_back(1e9 * (thread_seconds() - start) / static_cast<double>(sample.cases.size()));
}

Spread spread_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return {values[values.size() / 2], values.front(), values.back()};
}

// Of all scenes of the pack together; the first scene's reason stands for all.
std::vector<implementations::LeftOut> left_out_of(const std::vector<Scene>& pack) {
  std::vector<implementations::LeftOut> sums;
  for (const Scene& scene : pack)
    for (const auto& one : implementations::compilation_of(scene).left_out) {
      const auto known =
          std::find_if(sums.begin(), sums.end(), [&](const auto& sum) { return sum.what == one.what; });
      if (known == sums.end())
        sums.push_back(one);
      else
        known->count += one.count;
    }
  std::erase_if(sums, [](const auto& sum) { return sum.count == 0; });
  return sums;
}

}  // namespace

std::vector<LeftOutWorth> worth_of_left_out(const std::string& name, const std::vector<Scene>& pack,
                                            std::uint64_t seed, std::size_t asks, int rounds) {
  const Sample sample = draw(name, pack, tiers::AskKind::entry, Population::ordinary, seed, asks);
  std::vector<implementations::LeftOut> left_out = left_out_of(pack);
  left_out.push_back({"all", 0, "everything below at once"});
  std::rotate(left_out.begin(), left_out.end() - 1, left_out.end());
  Way as_compiled = compiled_without({}, sample);
  std::vector<Way> ways;
  for (const auto& one : left_out) {
    const bool is_all = one.what == "all";
    ways.push_back(compiled_without(
        is_all ? implementations::simplification_names() : std::vector<std::string>{one.what}, sample));
  }
  for (int round = 0; round < rounds; ++round) {
    take_time(as_compiled, sample);
    for (Way& way : ways) take_time(way, sample);
  }
  std::vector<LeftOutWorth> worths;
  for (std::size_t i = 0; i < ways.size(); ++i)
    worths.push_back({name, left_out[i].what, left_out[i].count, left_out[i].why, sample.cases.size(),
                      spread_of(as_compiled.nanoseconds), spread_of(ways[i].nanoseconds),
                      ways[i].answers == as_compiled.answers});
  return worths;
}

}  // namespace groundtruth::precision
