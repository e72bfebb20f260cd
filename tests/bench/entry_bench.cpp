// Entry asks: scenes x asks x engines, one thread. Times are per ask.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>

#include <benchmark/benchmark.h>
#include <groundtruth/as_written/entry_point.hpp>
#include <groundtruth/cases/ask_source.hpp>
#include <groundtruth/cases/random.hpp>
#include <groundtruth/cases/scene_builders.hpp>
#include <groundtruth/fast/decided_entry.hpp>
#include <groundtruth/fast/entry_point.hpp>
#include <groundtruth/tests/bench/timed_scenes.hpp>

namespace groundtruth::bench {
namespace {

constexpr std::size_t asks_per_set = 30000;

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

void register_scene(const TimedScene& scene) {
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
      *prepared =
          std::make_unique<Prepared>(Prepared{std::move(written), std::move(compiled), std::move(plain)});
    }
    return **prepared;
  };
  for (const AskKind& kind : ask_kinds()) {
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
      ask_all(state, asks, [&](const EntryAsk& ask) {
        return as_written::entry_point(*with.plain, ask, as_written::Errata{});
      });
    });
  }
  benchmark::RegisterBenchmark((scene.name + "/compile").c_str(), [=](benchmark::State& state) {
    const Prepared& with = prepare();
    for (auto _ : state) benchmark::DoNotOptimize(fast::compile(with.written));
  })->Unit(benchmark::kMillisecond);
}

// 300 random nested shapes of depth 8, asked in turn.
void register_nested() {
  struct Prepared {
    std::vector<fast::Scene> compiled;
    std::vector<as_written::Scene> plain;
    std::vector<EntryAsk> asks;
  };
  const auto prepared = std::make_shared<Prepared>();
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Scene scene = cases::random_nested(seed, 8, 4);
    prepared->compiled.push_back(fast::compile(scene));
    prepared->plain.emplace_back(scene);
  }
  prepared->asks = struts({8, 8, -4, -4, 4}, 30000);
  const auto run = [prepared](benchmark::State& state, const auto& scenes, auto answer) {
    std::size_t i = 0, scene = 0;
    for (auto _ : state) {
      benchmark::DoNotOptimize(answer(scenes[scene], prepared->asks[i]));
      if (++scene == scenes.size()) scene = 0;
      if (++i == prepared->asks.size()) i = 0;
    }
  };
  benchmark::RegisterBenchmark("nested/strut/fast", [=](benchmark::State& state) {
    run(state, prepared->compiled,
        [](const fast::Scene& s, const EntryAsk& ask) { return fast::entry_point(s, ask); });
  });
  benchmark::RegisterBenchmark("nested/strut/naive", [=](benchmark::State& state) {
    run(state, prepared->plain, [](const as_written::Scene& s, const EntryAsk& ask) {
      return as_written::entry_point(s, ask, as_written::Errata{});
    });
  });
}

bool is_of_this_world(const EntryAsk& ask) {
  const auto is_usual = [](double x) { return x == 0 || (std::abs(x) > 1e-20 && std::abs(x) <= 1e6); };
  return std::all_of(ask.from.begin(), ask.from.end(), is_usual) &&
         std::all_of(ask.to.begin(), ask.to.end(), is_usual) && is_usual(ask.lambda_first) &&
         is_usual(ask.lambda_last);
}

// Asks that only the exact stage can decide.
void register_ties(const std::string& name, const Scene& scene) {
  const auto compiled = std::make_shared<fast::Scene>(fast::compile(scene));
  cases::AskSource source(scene, 1, {1, 0, 0});
  std::vector<EntryAsk> ties;
  while (ties.size() < 5000) {
    const EntryAsk ask = std::get<EntryAsk>(source.next().ask);
    if (is_of_this_world(ask) && fast::decide_entry(*compiled, ask).place == fast::Stage::exact)
      ties.push_back(ask);
  }
  benchmark::RegisterBenchmark((name + "/ties/fast").c_str(), [=](benchmark::State& state) {
    ask_all(state, ties, [&](const EntryAsk& ask) { return fast::entry_point(*compiled, ask); });
  });
  benchmark::RegisterBenchmark((name + "/ties/quantiles").c_str(), [=](benchmark::State& state) {
    // The least of all rounds, ask by ask: what else the machine does is not counted.
    std::vector<double> times(ties.size(), std::numeric_limits<double>::infinity());
    for (auto _ : state) {
      for (std::size_t i = 0; i < ties.size(); ++i) {
        const auto start = std::chrono::steady_clock::now();
        benchmark::DoNotOptimize(fast::entry_point(*compiled, ties[i]));
        const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
        times[i] = std::min(times[i], time.count());
      }
    }
    std::sort(times.begin(), times.end());
    state.counters["median_ns"] = times[times.size() / 2];
    state.counters["p99_ns"] = times[times.size() * 99 / 100];
    state.counters["worst_ns"] = times.back();
  });
}

}  // namespace
}  // namespace groundtruth::bench

int main(int count, char** arguments) {
  for (const auto& scene : groundtruth::bench::timed_scenes()) groundtruth::bench::register_scene(scene);
  groundtruth::bench::register_nested();
  groundtruth::bench::register_ties("town-1k", groundtruth::cases::town_of(1000, 1));
  groundtruth::bench::register_ties("runway", groundtruth::cases::runway_of(200));
  groundtruth::bench::register_ties("hills", groundtruth::cases::hills_of(20));
  benchmark::Initialize(&count, arguments);
  benchmark::RunSpecifiedBenchmarks();
}
