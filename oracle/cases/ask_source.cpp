#include <array>
#include <utility>

#include <groundtruth/cases/ask_source.hpp>
#include <groundtruth/cases/clip_flavours.hpp>
#include <groundtruth/cases/entry_flavours.hpp>
#include <groundtruth/cases/neighbours.hpp>
#include <groundtruth/cases/random.hpp>
#include <groundtruth/cases/step_flavours.hpp>

namespace groundtruth::cases {
namespace {

template <class Make>
struct Entry {
  Flavour flavour;
  unsigned weight;
  Make* make;
};

using MakeEntry = EntryAsk(const Landmarks&, Random&);
using MakeClip = ClipAsk(Random&);
using MakeStep = StepAsk(const Landmarks&, Random&);

constexpr std::array<Entry<MakeEntry>, 21> entries{{
    {Flavour::entry_random, 10, entry_random},
    {Flavour::entry_strut, 10, entry_strut},
    {Flavour::entry_lattice, 6, entry_lattice},
    {Flavour::entry_through_face, 4, entry_through_face},
    {Flavour::entry_through_edge, 6, entry_through_edge},
    {Flavour::entry_through_corner, 6, entry_through_corner},
    {Flavour::entry_through_crossing, 3, entry_through_crossing},
    {Flavour::entry_in_face_plane, 6, entry_in_face_plane},
    {Flavour::entry_along_edge, 4, entry_along_edge},
    {Flavour::entry_across_seam, 5, entry_across_seam},
    {Flavour::entry_along_seam, 4, entry_along_seam},
    {Flavour::entry_over_seam, 4, entry_over_seam},
    {Flavour::entry_start_on_face, 4, entry_start_on_face},
    {Flavour::entry_start_on_edge, 4, entry_start_on_edge},
    {Flavour::entry_start_on_corner, 4, entry_start_on_corner},
    {Flavour::entry_start_inside, 4, entry_start_inside},
    {Flavour::entry_end_on_border, 4, entry_end_on_border},
    {Flavour::entry_point, 3, entry_point},
    {Flavour::entry_instant, 3, entry_instant},
    {Flavour::entry_from_afar, 3, entry_from_afar},
    {Flavour::entry_extreme_bits, 3, entry_extreme_bits},
}};

constexpr std::array<Entry<MakeClip>, 11> clips{{
    {Flavour::clip_random, 20, clip_random},
    {Flavour::clip_disc_border, 12, clip_disc_border},
    {Flavour::clip_band_edge, 10, clip_band_edge},
    {Flavour::clip_border_corner, 8, clip_border_corner},
    {Flavour::clip_case_border_1_2, 8, clip_case_border_1_2},
    {Flavour::clip_case_border_2_3, 8, clip_case_border_2_3},
    {Flavour::clip_wide_band, 8, clip_wide_band},
    {Flavour::clip_zeros, 8, clip_zeros},
    {Flavour::clip_steepness_limit, 6, clip_steepness_limit},
    {Flavour::clip_hopeless_surface, 4, clip_hopeless_surface},
    {Flavour::clip_extreme_bits, 8, clip_extreme_bits},
}};

constexpr std::array<Entry<MakeStep>, 17> steps{{
    {Flavour::step_free_hit, 10, step_free_hit},
    {Flavour::step_free_miss, 3, step_free_miss},
    {Flavour::step_free_limits, 6, step_free_limits},
    {Flavour::step_free_in_ground, 3, step_free_in_ground},
    {Flavour::step_resting, 8, step_resting},
    {Flavour::step_skidding, 16, step_skidding},
    {Flavour::step_turning, 6, step_turning},
    {Flavour::step_over_the_edge, 6, step_over_the_edge},
    {Flavour::step_z_limits, 5, step_z_limits},
    {Flavour::step_no_pressure, 4, step_no_pressure},
    {Flavour::step_gives_way, 4, step_gives_way},
    {Flavour::step_border, 9, step_border},
    {Flavour::step_lands_on_feature, 7, step_lands_on_feature},
    {Flavour::step_steepness_limit, 4, step_steepness_limit},
    {Flavour::step_stiff, 4, step_stiff},
    {Flavour::step_unknown_tyre, 2, step_unknown_tyre},
    {Flavour::step_extreme_bits, 5, step_extreme_bits},
}};

template <class Entries>
const auto& pick_by_weight(const Entries& entries_of_kind, Random& random) {
  unsigned total = 0;
  for (const auto& entry : entries_of_kind) total += entry.weight;
  std::uint64_t rest = random.below(total);
  for (const auto& entry : entries_of_kind) {
    if (rest < entry.weight) return entry;
    rest -= entry.weight;
  }
  return entries_of_kind.back();
}

template <class OneAsk>
GeneratedAsk placed(OneAsk ask, Flavour flavour, Random& random) {
  if (random.one_in(5)) return {neighbour(ask, random), flavour, Placement::one_ulp_off};
  return {std::move(ask), flavour, Placement::as_made};
}

}  // namespace

AskSource::AskSource(const Scene& scene, std::uint64_t seed, const AskMix& mix)
    : landmarks_(survey(scene)), seed_(seed), mix_(mix) {}

GeneratedAsk AskSource::ask_at(std::uint64_t index) const {
  Random random(seed_of_part(seed_, index));
  const std::uint64_t kind = random.below(std::uint64_t{mix_.entry} + mix_.clip + mix_.step);
  if (kind < mix_.entry) {
    const auto& entry = pick_by_weight(entries, random);
    return placed(entry.make(landmarks_, random), entry.flavour, random);
  }
  if (kind < std::uint64_t{mix_.entry} + mix_.clip) {
    const auto& clip = pick_by_weight(clips, random);
    return placed(clip.make(random), clip.flavour, random);
  }
  const auto& step = pick_by_weight(steps, random);
  return placed(step.make(landmarks_, random), step.flavour, random);
}

}  // namespace groundtruth::cases
