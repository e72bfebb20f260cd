#pragma once
// Phi over exact numbers of any kind: lambda, and the face (SPEC section 3). Not installed.

#include <groundtruth/fast/exact_stage/corner.hpp>
#include <groundtruth/fast/exact_stage/search.hpp>

namespace groundtruth::fast::exact_stage {

struct Found {
  std::optional<std::size_t> leaf;     // absent: the range starts in the interior
  std::optional<std::size_t> crossed;  // absent: lambda* is the range's first
  bool is_at_end = false;              // lambda* is the range's last
};

// The first point for t in [0, length] in the solid whose leaves go along `lines`.
template <class Numbers>
std::optional<Found> find_first_point(const Numbers& numbers, const ExpressionView& solid,
                                      const Lines<Numbers>& lines, const typename Numbers::Slope& length) {
  using Slope = typename Numbers::Slope;
  const Line<Numbers> start{{}, Slope(1), 1}, end{Numbers::value(-length), Slope(1), 1};
  const auto place = first_place(numbers, solid, lines, &start, &end);
  if (!place) return std::nullopt;

  Found found;
  const bool is_at_start = compare<Numbers>(numbers, *place, &start) == 0;
  found.is_at_end = compare<Numbers>(numbers, *place, &end) == 0;
  if (!is_at_start) found.crossed = static_cast<std::size_t>(*place - lines.data());
  LeavesNearPoint near(lines.size());
  for (std::size_t leaf = 0; leaf < lines.size(); ++leaf) {
    const int sign = side(numbers, lines[leaf], *place);
    if (sign != 0)
      near[leaf] = sign > 0 ? NearPoint::nothing : NearPoint::everything;
    else if (solid.leaves[leaf].normal == Vector{})
      near[leaf] = NearPoint::everything;
    else
      near[leaf] = lines[leaf].enters() ? NearPoint::entered : NearPoint::not_entered;
  }
  found.leaf = canonical_leaf(solid, near, is_at_start ? Arrival::starts_there : Arrival::enters_there);
  return found;
}

}  // namespace groundtruth::fast::exact_stage
