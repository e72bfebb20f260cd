#include <groundtruth/fast/arrival.hpp>
#include <groundtruth/fast/entry.hpp>
#include <groundtruth/fast/face.hpp>

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

}  // namespace groundtruth::fast
