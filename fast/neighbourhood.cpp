#include <groundtruth/fast/neighbourhood.hpp>

#include <algorithm>
#include <cmath>

#include <groundtruth/fast/box_way.hpp>
#include <groundtruth/fast/cell.hpp>

namespace groundtruth::fast {

namespace {

bool reaches(const BoxNode& node, std::uint32_t child, const Box& box) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (double{node.low[axis][child]} > box.high[axis] || double{node.high[axis][child]} < box.low[axis])
      return false;
  return true;
}

double greatest_coordinate(const Box& box) {
  double greatest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    greatest = std::max(greatest, std::max(std::abs(box.low[axis]), std::abs(box.high[axis])));
  return greatest;
}

// Rules whose regions hold no point of the box decide nothing there.
CellMaterial material_in(const Scene& scene, const Box& box, const CellMaterial& material) {
  if (material.material != CellMaterial::by_rules || material.rule == CellMaterial::unknown_rule)
    return material;
  CellMaterial sure{CellMaterial::none, material.rule};
  for (std::optional<std::uint32_t> at = material.rule; at; at = scene.rules()[*at].outer_rule) {
    const MaterialRule& rule = scene.rules()[*at];
    if (rule.region && !intersection(scene.region_boxes()[*rule.region], box).is_empty()) return material;
    if (!rule.region) sure.material = static_cast<std::uint32_t>(rule.material);
  }
  return sure;
}

}  // namespace

bool Neighbourhood::look_around(const Scene& scene, const Box& box) {
  cells_.groups.clear();
  cells_.leaves.clear();
  cells_.cells.clear();
  bool is_known = suit_boxes(greatest_coordinate(box), 0);
  for (const Part part : scene.parts().apart) is_known = is_known && add(scene, box, part);
  is_known = is_known && add_indexed(scene, box);
  if (!is_known) cells_.cells.clear();
  return is_known;
}

bool Neighbourhood::add_indexed(const Scene& scene, const Box& box) {
  const auto& nodes = scene.parts().hierarchy.nodes;
  open_.clear();
  if (!nodes.empty()) open_.push_back(0);
  while (!open_.empty()) {
    const BoxNode& node = nodes[open_.back()];
    open_.pop_back();
    for (std::uint32_t i = 0; i != BoxNode::width && node.children[i] != BoxNode::no_child; ++i) {
      if (!reaches(node, i, box)) continue;
      if (node.children[i] < BoxNode::first_part)
        open_.push_back(node.children[i]);
      else if (!add(scene, box, node.children[i] - BoxNode::first_part))
        return false;
    }
  }
  return true;
}

bool Neighbourhood::add(const Scene& scene, const Box& box, Part part) {
  const Parts& parts = scene.parts();
  if (!parts.is_cell(part)) return false;
  const Cell& cell = parts.cells.cells[part];
  if (is_apart(parts.cells, cell, box)) return true;
  if (cells_.cells.size() == most_cells) return false;
  numbers_.clear();
  half_spaces_.clear();
  for (std::uint32_t place = 0; place != cell.leaf_count; ++place) {
    const HalfSpace half_space = parts.cells.half_space_at(cell, place);
    if (greatest_delta(half_space, box) < 0) continue;
    numbers_.push_back(parts.cells.leaf_at(cell, place));
    half_spaces_.push_back(half_space);
  }
  cells_.add(numbers_, half_spaces_);
  cells_.cells.back().material = material_in(scene, box, cell.material);
  return true;
}

}  // namespace groundtruth::fast
