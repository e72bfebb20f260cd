// growth_table [MOST_HOUSES]: towns of 100, 1,000, ... houses: building, memory, ns per strut one by one and
// in bulk, and the factor per decade. Then which stage decided struts in every timed scene.

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include <groundtruth/fast/decided_entry.hpp>
#include <groundtruth/fast/entry_point.hpp>
#include <groundtruth/tests/bench/clock.hpp>
#include <groundtruth/tests/bench/memory.hpp>
#include <groundtruth/tests/bench/peer.hpp>
#include <groundtruth/tests/bench/timed_scenes.hpp>

namespace groundtruth::bench {
namespace {

constexpr std::size_t asks_per_scene = 100000;

template <class Work>
double seconds(Work work) {
  const double start = nanoseconds_so_far();
  work();
  return (nanoseconds_so_far() - start) * 1e-9;
}

double nanoseconds_per_ask(const Peer& peer, const std::vector<EntryAsk>& asks) {
  double best = 1e9;
  for (int round = 0; round < 7; ++round) best = std::min(best, seconds([&] { peer.answer(asks); }));
  return best * 1e9 / static_cast<double>(asks.size());
}

void print_growth(std::size_t most_houses) {
  std::printf("%9s %10s %10s %10s %9s %8s %9s %8s\n", "houses", "build s", "MB held", "MB peak", "ns/strut",
              "factor", "ns bulk", "factor");
  double last_single = 0, last_bulk = 0;
  for (std::size_t houses = 100; houses <= most_houses; houses *= 10) {
    const TimedScene timed = town("", houses);
    const Scene scene = timed.build();
    std::shared_ptr<const fast::Scene> compiled;
    const double build = seconds([&] { compiled = std::make_shared<fast::Scene>(fast::compile(scene)); });
    const std::vector<EntryAsk> asks = struts(timed.extent, asks_per_scene);
    const double single = nanoseconds_per_ask(fast_one_by_one(compiled), asks);
    const double bulk = nanoseconds_per_ask(fast_in_bulk(compiled), asks);
    std::printf("%9zu %10.3f %10.2f %10.1f %9.1f %8.2f %9.1f %8.2f\n", houses, build,
                static_cast<double>(bytes_of(*compiled)) / 1e6, static_cast<double>(peak_memory()) / 1e6,
                single, last_single > 0 ? single / last_single : 0, bulk,
                last_bulk > 0 ? bulk / last_bulk : 0);
    std::fflush(stdout);
    last_single = single;
    last_bulk = bulk;
  }
}

void print_stages() {
  std::printf("\n%-10s %-6s %12s %12s %14s %12s\n", "scene", "asks", "place dbl", "place exact",
              "lambda dbl-dbl", "lambda exact");
  for (const TimedScene& timed : timed_scenes()) {
    const fast::Scene compiled = fast::compile(timed.build());
    for (const AskKind& kind : ask_kinds()) {
      std::size_t place[5]{}, lambda[5]{};
      for (const EntryAsk& ask : kind.make(timed.extent, asks_per_scene)) {
        const fast::DecidedEntry decided = fast::decide_entry(compiled, ask);
        ++place[static_cast<std::size_t>(decided.place)];
        ++lambda[static_cast<std::size_t>(decided.lambda)];
      }
      const auto of = [](const std::size_t(&counts)[5], fast::Stage stage) {
        return counts[static_cast<std::size_t>(stage)];
      };
      std::printf("%-10s %-6s %12zu %12zu %14zu %12zu\n", timed.name.c_str(), kind.name.c_str(),
                  of(place, fast::Stage::doubles), of(place, fast::Stage::exact),
                  of(lambda, fast::Stage::double_pair), of(lambda, fast::Stage::exact));
    }
  }
}

}  // namespace
}  // namespace groundtruth::bench

int main(int count, char** arguments) {
  groundtruth::bench::print_growth(count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1000000);
  groundtruth::bench::print_stages();
}
