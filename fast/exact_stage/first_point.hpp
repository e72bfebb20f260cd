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

inline Normal<Dyadic> dyadic_normal(const HalfSpace& leaf) {
  return {leaf.normal[0], leaf.normal[1], leaf.normal[2]};
}

// The first point for t in [0, length] in the solid whose leaves go along `lines`.
template <class Numbers, class NormalOf>
std::optional<Found> find_first_point(const Numbers& numbers, const ExpressionView& solid,
                                      const Lines<Numbers>& lines, const typename Numbers::Slope& length,
                                      NormalOf normal_of) {
  using Slope = typename Numbers::Slope;
  const Line<Numbers> start{{}, Slope(1), 1}, end{Numbers::value(-length), Slope(1), 1};
  const auto place = Search<Numbers>(numbers, solid, lines).first_place(&start, &end);
  if (!place) return std::nullopt;

  Found found;
  const bool is_at_start = *place == &start || compare<Numbers>(numbers, *place, &start) == 0;
  found.is_at_end = compare<Numbers>(numbers, *place, &end) == 0;
  if (!is_at_start) found.crossed = static_cast<std::size_t>(*place - lines.data());
  LeafValues values(lines.size());
  for (std::size_t leaf = 0; leaf < lines.size(); ++leaf) {
    const int sign = side(numbers, lines[leaf], *place);
    values[leaf] = sign > 0 ? Value::nothing : sign < 0 ? Value::everything : Value::open;
    if (sign == 0 && solid.leaves[leaf].normal == Vector{}) values[leaf] = Value::everything;
  }
  const Corner<Numbers> corner(numbers, solid, values, normal_of);
  if (is_at_start && corner.is_interior()) return found;
  found.leaf = corner.canonical_leaf([&](std::size_t leaf) { return is_at_start || lines[leaf].enters(); });
  return found;
}

}  // namespace groundtruth::fast::exact_stage
