// counted_asks SCENE ASKS PEER: one peer answers a thousand asks once, in answer_counted(), so that a
// simulator can count what that takes (instruction_table.py).

#include <cstdio>
#include <string>

#include <groundtruth/fast/entry_point.hpp>
#include <groundtruth/tests/bench/peer.hpp>
#include <groundtruth/tests/bench/timed_scenes.hpp>

namespace groundtruth::bench {

[[gnu::noinline]] std::size_t answer_counted(const Peer& peer, std::span<const EntryAsk> asks) {
  return peer.answer(asks);
}

namespace {

constexpr std::size_t ask_count = 1000;

template <class Named>
const Named* find(const std::vector<Named>& all, const std::string& name) {
  for (const Named& one : all)
    if (one.name == name) return &one;
  return nullptr;
}

int run(const std::string& scene_name, const std::string& kind_name, const std::string& peer_name) {
  const TimedScene* const timed = find(timed_scenes(), scene_name);
  const AskKind* const kind = find(ask_kinds(), kind_name);
  if (timed == nullptr || kind == nullptr) return 2;
  const Scene scene = timed->build();
  const auto compiled = std::make_shared<const fast::Scene>(fast::compile(scene));
  const std::vector<Peer> peers{fast_one_by_one(compiled),   fast_warm(compiled),  fast_in_bulk(compiled),
                                without_certainty(compiled), one_pass_clip(scene), naive_doubles(scene)};
  const Peer* const peer = find(peers, peer_name);
  if (peer == nullptr || !peer->answer) return 2;
  const std::vector<EntryAsk> asks = kind->make(timed->extent, ask_count);
  std::printf("%zu asks, %zu hit\n", asks.size(), answer_counted(*peer, asks));
  return 0;
}

}  // namespace
}  // namespace groundtruth::bench

int main(int count, char** arguments) {
  if (count == 4 && groundtruth::bench::run(arguments[1], arguments[2], arguments[3]) == 0) return 0;
  std::fprintf(stderr,
               "usage: counted_asks SCENE ASKS PEER (of the scenes, asks and peers of speed_table)\n");
  return 2;
}
