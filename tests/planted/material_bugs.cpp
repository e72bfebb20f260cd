// Mistakes about what a face is made of.

#include <algorithm>

#include "ways.hpp"

namespace groundtruth::planted {
namespace {

using Color = std::optional<MaterialIndex> (*)(const Meeting&, const PlacedLeaf&);

template <Color color>
EntryAnswer colored(const Meeting& meeting) {
  Border border = meeting.border;
  border.material = color(meeting, meeting.right.leaves()[border.leaf]);
  return border;
}

std::optional<MaterialIndex> first_along(const std::vector<const Shape*>& around, const Place& point) {
  return material_of({HalfSpace{}, around}, point);
}

std::optional<MaterialIndex> innermost(const Meeting& meeting, const PlacedLeaf& leaf) {
  return first_along({leaf.around.rbegin(), leaf.around.rend()}, meeting.point);
}

std::optional<MaterialIndex> paint_first(const Meeting& meeting, const PlacedLeaf& leaf) {
  std::vector<const Shape*> around = leaf.around;
  std::stable_partition(around.begin(), around.end(), [](const Shape* shape) {
    return std::holds_alternative<Painted>(shape->expression);
  });
  return first_along(around, meeting.point);
}

std::optional<MaterialIndex> outermost_paint_only(const Meeting& meeting, const PlacedLeaf& leaf) {
  std::vector<const Shape*> around;
  bool painted = false;
  for (const Shape* shape : leaf.around) {
    const bool is_paint = std::holds_alternative<Painted>(shape->expression);
    if (!is_paint || !painted) around.push_back(shape);
    painted = painted || is_paint;
  }
  return first_along(around, meeting.point);
}

std::optional<MaterialIndex> region_at_from(const Meeting& meeting, const PlacedLeaf& leaf) {
  return material_of(leaf, place(meeting.ask.from));
}

std::optional<MaterialIndex> region_on_the_map(const Meeting& meeting, const PlacedLeaf& leaf) {
  return material_of(leaf, {meeting.point[0], meeting.point[1], Rational(0)});
}

// A point on a plane of a region lies outside of it.
std::optional<MaterialIndex> region_without_border(const Meeting& meeting, const PlacedLeaf& leaf) {
  for (const Shape* shape : leaf.around) {
    if (const auto* covered = std::get_if<Covered>(&shape->expression)) return covered->material;
    const auto* painted = std::get_if<Painted>(&shape->expression);
    if (painted == nullptr || !contains(*painted->where, meeting.point)) continue;
    const std::vector<PlacedLeaf> edges = leaves_of(*painted->where);
    const bool on_edge = std::any_of(edges.begin(), edges.end(), [&](const PlacedLeaf& edge) {
      return edge.half_space.normal != Vector{} && side_of(edge.half_space, meeting.point) == 0;
    });
    if (!on_edge) return painted->material;
  }
  return std::nullopt;
}

std::optional<MaterialIndex> none_is_first(const Meeting& meeting, const PlacedLeaf&) {
  if (meeting.border.material || meeting.right.scene().materials.empty()) return meeting.border.material;
  return MaterialIndex{0};
}

std::optional<MaterialIndex> left_over(const Meeting& meeting, const PlacedLeaf&) {
  if (meeting.border.material || meeting.border.leaf == 0) return meeting.border.material;
  return meeting.on(meeting.border.leaf - 1).material;
}

std::optional<MaterialIndex> of_first_tied(const Meeting& meeting, const PlacedLeaf&) {
  const std::vector<Leaf> leaves = meeting.tied();
  return leaves.empty() ? meeting.border.material : meeting.on(leaves.front()).material;
}

}  // namespace

std::vector<Bug> material_bugs() {
  using enum Reach;
  constexpr Kind entry = Kind::entry;
  return {
      {"innermost-material", entry, special, "the innermost material wins", on_borders(colored<innermost>)},
      {"paint-before-material", entry, special, "paint wins over a material around it",
       on_borders(colored<paint_first>)},
      {"outermost-paint-only", entry, special, "a paint within a paint is overlooked",
       on_borders(colored<outermost_paint_only>)},
      {"region-at-from", entry, special, "paint looks where the segment starts",
       on_borders(colored<region_at_from>)},
      {"region-on-the-map", entry, special, "paint looks at height 0",
       on_borders(colored<region_on_the_map>)},
      {"region-without-border", entry, tied, "a painted region is open",
       on_borders(colored<region_without_border>)},
      {"no-material-is-first", entry, special, "no material is read as material 0",
       on_borders(colored<none_is_first>)},
      {"material-left-over", entry, special, "a face without material has that of the face before",
       on_borders(colored<left_over>)},
      {"material-of-first-tied", entry, tied, "the leaf is right, the material that of another face there",
       on_borders(colored<of_first_tied>)},
  };
}

}  // namespace groundtruth::planted
