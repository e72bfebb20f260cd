// Entry asks: scenes x asks x engines, one thread. Times are per ask.

#include <functional>
#include <memory>
#include <string>

#include <benchmark/benchmark.h>
#include <groundtruth/as_written/entry_point.hpp>
#include <groundtruth/cases/random.hpp>
#include <groundtruth/cases/scene_builders.hpp>
#include <groundtruth/exact/entry_point.hpp>
#include <groundtruth/fast/entry_point.hpp>
#include <groundtruth/tests/bench/asks.hpp>

namespace groundtruth::bench {
namespace {

constexpr std::size_t asks_per_set = 30000;
constexpr double houses_100k = 317 * 24, houses_1k = 32 * 24;

struct BenchScene {
  std::string name;
  std::function<Scene()> build;
  Extent extent;
};

std::vector<BenchScene> scenes() {
  return {
      {"house", cases::house, {10, 10, -5, 0, 8}},
      {"runway", [] { return cases::runway_of(1000); }, {10000, 30, 0, 0, 1.5}},
      {"town-1k", [] { return cases::town_of(1000, 1); }, {houses_1k, houses_1k, 0, 0, 8}},
      {"town-100k", [] { return cases::town_of(100000, 1); }, {houses_100k, houses_100k, 0, 0, 8}},
      {"hills-20k", [] { return cases::hills_of(100); }, {800, 800, 0, 0, 5}},
  };
}

struct AskKind {
  std::string name;
  std::vector<EntryAsk> (*make)(const Extent&, std::size_t);
};

const std::vector<AskKind> ask_kinds{{"strut", struts}, {"taxi", taxi}, {"long", long_ones}};

// Asks one after the other, round and round; the share of hits goes with the time.
template <class Answer>
void ask_all(benchmark::State& state, const std::vector<EntryAsk>& asks, Answer answer) {
  std::size_t i = 0, hits = 0;
  for (auto _ : state) {
    const EntryAnswer got = answer(asks[i]);
    hits += got.index() != 0;
    if (++i == asks.size()) i = 0;
  }
  state.counters["hits"] = static_cast<double>(hits) / static_cast<double>(state.iterations());
}

void register_scene(const BenchScene& scene) {
  struct Prepared {
    Scene written;
    fast::Scene compiled;
    std::unique_ptr<as_written::Scene> plain;
  };
  const auto prepared = std::make_shared<std::unique_ptr<Prepared>>();
  const auto prepare = [=]() -> const Prepared& {
    if (!*prepared) {
      Scene written = scene.build();
      fast::Scene compiled = fast::compile(written);
      auto plain = std::make_unique<as_written::Scene>(written);
      *prepared = std::make_unique<Prepared>(Prepared{std::move(written), std::move(compiled), std::move(plain)});
    }
    return **prepared;
  };
  for (const AskKind& kind : ask_kinds) {
    const std::vector<EntryAsk> asks = kind.make(scene.extent, asks_per_set);
    const std::string name = scene.name + "/" + kind.name + "/";
    benchmark::RegisterBenchmark((name + "fast").c_str(), [=](benchmark::State& state) {
      const Prepared& with = prepare();
      ask_all(state, asks, [&](const EntryAsk& ask) { return fast::entry_point(with.compiled, ask); });
    });
    benchmark::RegisterBenchmark((name + "fast-bulk").c_str(), [=](benchmark::State& state) {
      const Prepared& with = prepare();
      std::vector<EntryAnswer> answers(asks.size());
      for (auto _ : state) fast::entry_points(with.compiled, asks, answers);
      state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(asks.size()));
      state.counters["ns_per_ask"] =
          benchmark::Counter(static_cast<double>(asks.size()) * 1e-9,
                             benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
    });
    benchmark::RegisterBenchmark((name + "naive").c_str(), [=](benchmark::State& state) {
      const Prepared& with = prepare();
      ask_all(state, asks,
              [&](const EntryAsk& ask) { return as_written::entry_point(*with.plain, ask, as_written::Errata{}); });
    });
  }
  benchmark::RegisterBenchmark((scene.name + "/compile").c_str(), [=](benchmark::State& state) {
    const Prepared& with = prepare();
    for (auto _ : state) benchmark::DoNotOptimize(fast::compile(with.written));
  })->Unit(benchmark::kMillisecond);
}

}  // namespace
}  // namespace groundtruth::bench

int main(int count, char** arguments) {
  for (const auto& scene : groundtruth::bench::scenes()) groundtruth::bench::register_scene(scene);
  benchmark::Initialize(&count, arguments);
  benchmark::RunSpecifiedBenchmarks();
}
