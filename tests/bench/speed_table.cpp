// speed_table [SCENE...]: ns per entry ask, every peer in turn on the same asks, round after round, on one
// thread. Medians, and the median over the rounds of the ratio to the first peer, Embree (or fast without
// it). Before a quick peer is timed it answers the same asks once, so that no peer pays for what the one
// before it drove out of the caches. Peers whose work grows with the scene answer the first asks only: the
// last column says how many.

#include <algorithm>
#include <cstdio>

#include <groundtruth/fast/entry_point.hpp>
#include <groundtruth/tests/bench/clock.hpp>
#include <groundtruth/tests/bench/peer.hpp>
#include <groundtruth/tests/bench/timed_scenes.hpp>

namespace groundtruth::bench {
namespace {

constexpr std::size_t asks_per_round = 30000, rounds = 15, fewest_asks = 20;
constexpr double longest_round = 5e7;  // ns, of a slow peer

double nanoseconds(const Peer& peer, std::span<const EntryAsk> asks, std::size_t& hits) {
  const double start = nanoseconds_so_far();
  hits = peer.answer(asks);
  return (nanoseconds_so_far() - start) / static_cast<double>(asks.size());
}

// The quick ones answer all: a single slow start must not cut their share.
std::size_t affordable(const Peer& peer, std::span<const EntryAsk> asks) {
  if (peer.pace == Pace::quick) return asks.size();
  std::size_t ignored;
  const double once = nanoseconds(peer, asks.first(fewest_asks), ignored);
  return std::clamp(static_cast<std::size_t>(longest_round / once), fewest_asks, asks.size());
}

double median(std::vector<double> numbers) {
  std::sort(numbers.begin(), numbers.end());
  return numbers[numbers.size() / 2];
}

void print_table(const std::string& title, const std::vector<Peer>& peers,
                 const std::vector<EntryAsk>& asks) {
  std::vector<std::size_t> counts, hits(peers.size());
  for (const Peer& peer : peers) counts.push_back(affordable(peer, asks));
  std::vector<std::vector<double>> times(peers.size());
  for (std::size_t round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < peers.size(); ++i) {
      if (peers[i].pace == Pace::quick) peers[i].answer(asks);
      times[i].push_back(nanoseconds(peers[i], std::span(asks).first(counts[i]), hits[i]));
    }
  std::printf("%s\n", title.c_str());
  for (std::size_t i = 0; i < peers.size(); ++i) {
    std::vector<double> ratios;
    for (std::size_t round = 0; round < rounds; ++round) ratios.push_back(times[i][round] / times[0][round]);
    std::printf("  %-18s %12.1f ns  %10.3f of %s  %5.1f%% hit of %zu\n", peers[i].name.c_str(),
                median(times[i]), median(ratios), peers[0].name.c_str(),
                100 * static_cast<double>(hits[i]) / static_cast<double>(counts[i]), counts[i]);
  }
  std::fflush(stdout);
}

void run(const TimedScene& timed) {
  const Scene scene = timed.build();
  const double reach = 3 * (timed.extent.width + timed.extent.depth);
  const auto compiled = std::make_shared<const fast::Scene>(fast::compile(scene));
  std::vector<Peer> peers{embree(scene, reach),   fast_one_by_one(compiled),    without_certainty(compiled),
                          one_pass_clip(scene),   embree_packets(scene, reach), fast_warm(compiled),
                          fast_in_bulk(compiled), bullet(scene, reach),         naive_doubles(scene),
                          exact_engine(scene)};
  std::erase_if(peers, [](const Peer& peer) { return !peer.answer; });
  for (const AskKind& kind : ask_kinds())
    print_table(timed.name + ", " + kind.name, peers, kind.make(timed.extent, asks_per_round));
}

}  // namespace
}  // namespace groundtruth::bench

int main(int count, char** arguments) {
  using namespace groundtruth::bench;
  const std::vector<std::string> wanted(arguments + 1, arguments + count);
  for (const TimedScene& scene : timed_scenes())
    if (wanted.empty() || std::find(wanted.begin(), wanted.end(), scene.name) != wanted.end()) run(scene);
}
