#include <groundtruth/fast/entry_point.hpp>

#include <algorithm>

#include <boost/container/static_vector.hpp>
#include <groundtruth/fast/cell_kernels.hpp>
#include <groundtruth/fast/decided_entry.hpp>
#include <groundtruth/fast/paint.hpp>
#include <groundtruth/fast/undecided.hpp>

namespace groundtruth::fast {

namespace {

DecidedEntry on_face(const Scene& scene, const Probe& probe, const EntryAsk& ask, const HitPlace& place,
                     Stage place_stage, const RoundedLambda& lambda) {
  const FaceMaterial found = material_at(scene, probe, ask, place);
  return {Border{lambda.value, place.face.leaf, place.face.half_space.normal, found.material}, place_stage,
          lambda.stage, found.stage};
}

DecidedEntry exactly(const Scene& scene, const Probe& probe, const EntryAsk& ask, SearchResult& result) {
  const double lower = result.lower();
  const auto entry = decide(scene, probe, ask, result);
  if (!entry) return {Miss{}, Stage::exact, Stage::none, Stage::none};
  const RoundedLambda& lambda = entry->lambda;
  if (entry->leaf == no_leaf) return {Inside{lambda.value}, Stage::exact, lambda.stage, Stage::none};
  const HitPlace place{
      lower, result.upper, {entry->leaf, scene.solid().leaves[entry->leaf], by_rules}, entry->crossed};
  return on_face(scene, probe, ask, place, Stage::exact, lambda);
}

}  // namespace

DecidedEntry decide_entry(const Scene& scene, const EntryAsk& ask) {
  const Probe probe(ends_of(ask));
  SearchResult result;
  search(scene, probe, result);
  if (result.starts_inside) return {Inside{ask.lambda_first + 0.0}, Stage::doubles, Stage::none, Stage::none};
  if (result.contenders.empty()) return {Miss{}, Stage::doubles, Stage::none, Stage::none};
  const Face face = sole_face(scene, probe, result);
  if (face.leaf == no_leaf) return exactly(scene, probe, ask, result);
  const HitPlace place{result.lower(), result.upper, face, face.half_space};
  return on_face(scene, probe, ask, place, Stage::doubles,
                 correctly_rounded_crossing(*scene.parts().kernels, face.half_space, ask));
}

EntryAnswer entry_point(const Scene& scene, const EntryAsk& ask) { return decide_entry(scene, ask).answer; }

void entry_points(const Scene& scene, std::span<const EntryAsk> asks, std::span<EntryAnswer> answers) {
  // What has few squares is in the cache.
  constexpr std::size_t fewest_entries = 10000;
  if (scene.parts().grid.entries.size() < fewest_entries) {
    for (std::size_t i = 0; i != asks.size(); ++i) answers[i] = entry_point(scene, asks[i]);
    return;
  }
  constexpr std::size_t most_in_flight = 16;
  boost::container::static_vector<Prefetcher, most_in_flight> in_flight;
  for (std::size_t first = 0; first < asks.size(); first += most_in_flight) {
    const std::size_t end = std::min(asks.size(), first + most_in_flight);
    in_flight.clear();
    for (std::size_t i = first; i != end; ++i) {
      in_flight.emplace_back(scene, ends_of(asks[i]));
      in_flight.back().fetch_starts();
    }
    for (Prefetcher& ask : in_flight) ask.fetch_entries();
    for (Prefetcher& ask : in_flight) ask.fetch_cells();
    for (Prefetcher& ask : in_flight) ask.fetch_half_spaces();
    for (std::size_t i = first; i != end; ++i) answers[i] = entry_point(scene, asks[i]);
  }
}

}  // namespace groundtruth::fast
