#include <groundtruth/diagnosis/witnesses.hpp>

#include <algorithm>
#include <map>
#include <utility>

#include <groundtruth/cases/shape_parts.hpp>
#include <groundtruth/judge/difference.hpp>

namespace groundtruth::diagnosis {
namespace {

using Kind = std::pair<std::size_t, judge::Difference>;

Kind kind_of(const Witness& witness) {
  const Evidence none;
  const auto comparison = judge::compare({witness.got, none}, {witness.exact, none});
  return {witness.asked.ask.index(), comparison.difference};
}

// Scenes of up to 20 leaves are alike; then each doubling counts.
std::size_t largeness(const Witness& witness) {
  std::size_t doublings = 0;
  for (std::size_t leaves = cases::leaf_count(witness.asked.scene.shape); leaves > 20; leaves /= 2)
    ++doublings;
  return doublings;
}

}  // namespace

std::vector<const Witness*> in_turns(std::span<const Witness> all, std::size_t most) {
  std::map<Kind, std::vector<std::pair<std::size_t, const Witness*>>> by_kind;
  for (const Witness& witness : all) by_kind[kind_of(witness)].emplace_back(largeness(witness), &witness);
  for (auto& [kind, witnesses] : by_kind)
    std::stable_sort(witnesses.begin(), witnesses.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<const Witness*> taken;
  for (std::size_t turn = 0; taken.size() < std::min(most, all.size()); ++turn)
    for (const auto& [kind, witnesses] : by_kind)
      if (turn < witnesses.size() && taken.size() < most) taken.push_back(witnesses[turn].second);
  return taken;
}

}  // namespace groundtruth::diagnosis
