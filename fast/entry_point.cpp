#include <groundtruth/fast/arrival.hpp>
#include <groundtruth/fast/entry.hpp>
#include <groundtruth/fast/entry_point.hpp>
#include <groundtruth/fast/face.hpp>
#include <groundtruth/fast/material.hpp>

namespace groundtruth::fast {

template <class Number>
std::optional<Entry<Number>> find_entry(const Scene& scene, const Segment<Number>& segment,
                                        Range<Number> range) {
  const Expression& solid = scene.solid();
  const auto arrival = ArrivalSearch<Number>(solid, segment).first(range);
  if (!arrival) return std::nullopt;
  if (arrival->sole_leaf) return Entry<Number>{arrival->lambda, arrival->sole_leaf};
  const LocalShape shape = local_shape(solid, segment, arrival->lambda);
  const bool is_at_start = arrival->lambda == range.first;
  if (is_at_start && is_interior(shape, solid)) return Entry<Number>{arrival->lambda, std::nullopt};
  const auto candidates = is_at_start ? Candidates::all_leaves : Candidates::entered_leaves;
  return Entry<Number>{arrival->lambda, canonical_leaf(shape, solid, candidates)};
}

template std::optional<Entry<double>> find_entry(const Scene&, const Segment<double>&, Range<double>);
template std::optional<Entry<Wide>> find_entry(const Scene&, const Segment<Wide>&, Range<Wide>);

namespace {

template <class Number>
EntryAnswer answer(const Scene& scene, const EntryAsk& ask) {
  const Segment<Number> segment(as<Number>(ask.from), as<Number>(ask.to));
  const auto entry = find_entry<Number>(scene, segment, {ask.lambda_first, ask.lambda_last});
  if (!entry) return Miss{};
  const auto lambda = static_cast<double>(entry->lambda);
  if (!entry->leaf) return Inside{lambda};
  return Border{lambda, *entry->leaf, scene.solid().leaves[*entry->leaf].normal,
                material_at(scene, *entry->leaf, segment, entry->lambda)};
}

}  // namespace

EntryAnswer entry_point(const Scene& scene, const EntryAsk& ask) {
  const bool is_ordinary =
      scene.is_of_ordinary_size() && ordinary_size.contains(ask.from) && ordinary_size.contains(ask.to);
  return is_ordinary ? answer<double>(scene, ask) : answer<Wide>(scene, ask);
}

}  // namespace groundtruth::fast
