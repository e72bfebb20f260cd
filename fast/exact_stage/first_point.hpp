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

// Of a solid at a point of its border: `starts` there, or is entered there by the leaves `enters(leaf)`.
// Nothing: the point lies in the interior.
template <class Number, class NormalOf, class Enters>
std::optional<std::size_t> face_at(const Standing& standing, bool starts, NormalOf normal_of, Enters enters) {
  const Corner<Number> corner(standing, normal_of);
  if (starts && corner.is_interior()) return std::nullopt;
  return corner.canonical_leaf([&](std::size_t leaf) { return starts || enters(leaf); });
}

// The first point for t in [0, length] in the solid whose leaves go along `lines`.
template <class Numbers>
std::optional<Found> find_first_point(const Numbers& numbers, const ExpressionView& solid,
                                      const Lines<Numbers>& lines, const typename Numbers::Slope& length) {
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
  const Standing standing(solid, values);
  const auto enters = [&](std::size_t leaf) { return lines[leaf].enters(); };
  if (have_short_normals(standing))
    found.leaf = face_at<MachineInteger>(
        standing, is_at_start, [&](std::size_t leaf) { return machine_normal(solid.leaves[leaf]); }, enters);
  else
    found.leaf = face_at<Dyadic>(
        standing, is_at_start, [&](std::size_t leaf) { return dyadic_normal(solid.leaves[leaf]); }, enters);
  return found;
}

}  // namespace groundtruth::fast::exact_stage
