#include <groundtruth/fast/divide.hpp>

#include <algorithm>
#include <functional>
#include <string_view>
#include <unordered_map>

#include <groundtruth/fast/cell_kernels.hpp>

namespace groundtruth::fast {

namespace {

// More parts without a bounded box than this are not looked at one by one.
constexpr std::size_t most_unbounded_parts = 8;
constexpr std::size_t fewest_parts_for_hierarchy = 5;

class Divider {
 public:
  Divider(const Expression& solid, const CompileOptions& options, std::vector<LeftOut>& left_out)
      : solid_(solid), options_(options), left_out_(left_out) {}

  Parts result() {
    parts_.kernels =
        options_.instructions() == Instructions::portable ? &portable_cell_kernels : &best_cell_kernels();
    const Node* root = solid_.nodes.data();
    if (root->kind != NodeKind::union_of) {
      add(root);
    } else {
      for (const Node* operand = root + 1; operand != root + root->size; operand += operand->size)
        add(operand);
    }
    drop_buried();
    pack();
    report();
    parts_.cells.groups.shrink_to_fit();
    parts_.cells.leaves.shrink_to_fit();
    parts_.cells.cells.shrink_to_fit();
    return std::move(parts_);
  }

 private:
  struct ConvexPart {
    std::uint32_t node;
    std::uint32_t first_leaf;  // in leaves_
    std::uint32_t end_leaf;
    Box box;
  };

  bool has(Simplification simplification) const { return options_.has(simplification); }

  static bool is_convex(const Node* node) {
    if (node->kind == NodeKind::cell) return true;
    if (node->kind != NodeKind::intersection_of) return false;
    return std::all_of(node + 1, node + node->size, [](const Node& n) { return n.kind == NodeKind::cell; });
  }

  void add(const Node* node) {
    if (node->kind == NodeKind::nothing) return;
    const auto place = static_cast<std::uint32_t>(node - solid_.nodes.data());
    if (!is_convex(node)) {
      general_.push_back({place, 0, 0, box_around(solid_, node)});
      return;
    }
    const auto first = static_cast<std::uint32_t>(leaves_.size());
    for (const Node* cell = node; cell != node + node->size; ++cell)
      for (std::uint32_t leaf = cell->first_leaf; leaf != cell->end_leaf; ++leaf) leaves_.push_back(leaf);
    const auto end = static_cast<std::uint32_t>(leaves_.size());
    half_spaces_.clear();
    for (std::uint32_t i = first; i != end; ++i) half_spaces_.push_back(solid_.leaves[leaves_[i]]);
    const auto forget = [&](std::size_t& count) {
      leaves_.resize(first);
      ++count;
    };
    if (has(Simplification::duplicates) && is_written_before(first)) return forget(duplicates_);
    const Box box = box_around(half_spaces_);
    if (has(Simplification::empty_cells) && box.is_empty()) return forget(empty_);
    convex_.push_back({place, first, end, box});
  }

  // Is there an earlier part like half_spaces_? (One of two that share a hash may stay.)
  bool is_written_before(std::uint32_t first_leaf) {
    std::size_t hash = half_spaces_.size();
    for (const HalfSpace& half_space : half_spaces_)
      for (const double number :
           {half_space.normal[0], half_space.normal[1], half_space.normal[2], half_space.offset})
        hash = (hash ^ std::hash<double>{}(number)) * 0x9e3779b97f4a7c15;
    const auto [at, is_new] = first_leaf_by_hash_.try_emplace(hash, first_leaf);
    if (is_new || at->second + half_spaces_.size() > first_leaf) return false;
    for (std::size_t i = 0; i < half_spaces_.size(); ++i)
      if (!(solid_.leaves[leaves_[at->second + i]] == half_spaces_[i])) return false;
    return true;
  }

  // A point of a cell strictly inside a half-space of the union is interior, whatever the cell says.
  void drop_buried() {
    if (!has(Simplification::buried_parts)) return;
    std::vector<const ConvexPart*> grounds;
    for (const ConvexPart& part : convex_)
      if (part.end_leaf == part.first_leaf + 1) grounds.push_back(&part);
    if (grounds.empty() || grounds.size() > most_unbounded_parts) return;
    std::vector<ConvexPart> kept;
    for (const ConvexPart& part : convex_) {
      const bool is_buried = std::any_of(grounds.begin(), grounds.end(), [&](const ConvexPart* ground) {
        return greatest_delta(solid_.leaves[leaves_[ground->first_leaf]], part.box) < 0;
      });
      if (is_buried)
        ++buried_;
      else
        kept.push_back(part);
    }
    convex_ = std::move(kept);
  }

  void pack() {
    index();
    parts_.cells.cells.reserve(order_.size());
    for (const std::uint32_t place : order_) pack_cell(convex_[place]);
    for (const ConvexPart& part : general_) parts_.general.push_back(part.node);
  }

  void pack_cell(const ConvexPart& part) {
    kept_.assign(leaves_.begin() + part.first_leaf, leaves_.begin() + part.end_leaf);
    for (std::size_t i = 0; i < kept_.size();) {
      std::size_t* const reason = reason_to_drop(part, kept_, i);
      if (reason) {
        ++*reason;
        kept_.erase(kept_.begin() + static_cast<std::ptrdiff_t>(i));
      } else {
        ++i;
      }
    }
    parts_.cells.add(kept_, solid_.leaves);
  }

  // Null: kept[i] must stay. Of equal leaves the first is canonical. A plane beyond a box that the others
  // span is met by no point of the cell; only oblique ones are looked at: the others span the box themselves.
  std::size_t* reason_to_drop(const ConvexPart& part, const std::vector<std::uint32_t>& kept, std::size_t i) {
    const HalfSpace& half_space = solid_.leaves[kept[i]];
    const auto is_written_alike = [&](std::uint32_t leaf) { return solid_.leaves[leaf] == half_space; };
    if (has(Simplification::duplicates) &&
        std::any_of(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(i), is_written_alike))
      return &duplicates_;
    const auto& n = half_space.normal;
    const int axes = (n[0] != 0) + (n[1] != 0) + (n[2] != 0);
    if (!has(Simplification::redundant_half_spaces) || axes < 2 ||
        !(greatest_delta(half_space, part.box) < 0))
      return nullptr;
    half_spaces_.clear();
    for (std::size_t other = 0; other < kept.size(); ++other)
      if (other != i) half_spaces_.push_back(solid_.leaves[kept[other]]);
    return greatest_delta(half_space, box_around(half_spaces_)) < 0 ? &redundant_ : nullptr;
  }

  // Cells get the order in which the hierarchy comes to them, so that neighbours in space are neighbours in
  // memory.
  void index() {
    std::vector<Box> boxes;
    for (const auto* list : {&convex_, &general_})
      for (const ConvexPart& part : *list) boxes.push_back(part.box);
    std::vector<std::uint32_t> bounded, unbounded_ones;
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
      (boxes[i].is_bounded() ? bounded : unbounded_ones).push_back(i);
    if (unbounded_ones.size() > most_unbounded_parts) {
      bounded.insert(bounded.end(), unbounded_ones.begin(), unbounded_ones.end());
      unbounded_ones.clear();
    }
    // An empty box is met nowhere; hulls do not know it.
    const auto is_empty = [&](std::uint32_t i) { return boxes[i].is_empty(); };
    bounded.erase(std::remove_if(bounded.begin(), bounded.end(), is_empty), bounded.end());

    BoxHierarchy hierarchy;
    const bool is_worth_it =
        has(Simplification::hierarchy) && boxes.size() >= fewest_parts_for_hierarchy && !bounded.empty();
    if (is_worth_it) hierarchy = build_hierarchy(boxes, bounded);
    const std::vector<std::uint32_t> new_number = renumber(hierarchy, boxes.size());
    for (BoxNode& node : hierarchy.nodes)
      for (std::uint32_t& child : node.children)
        if (child >= BoxNode::first_part && child != BoxNode::no_child)
          child = BoxNode::first_part + new_number[child - BoxNode::first_part];
    std::vector<Box> boxes_by_new_number(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) boxes_by_new_number[new_number[i]] = boxes[i];
    for (std::uint32_t& part : bounded) part = new_number[part];
    if (is_worth_it) {
      for (const std::uint32_t part : unbounded_ones) parts_.apart.push_back(new_number[part]);
      if (has(Simplification::grid) && unbounded_ones.size() <= most_unbounded_parts)
        parts_.grid = build_grid_over(boxes_by_new_number, bounded);
    } else {
      for (std::uint32_t i = 0; i < boxes.size(); ++i) parts_.apart.push_back(i);
    }
    parts_.hierarchy = std::move(hierarchy);
  }

  static Grid build_grid_over(const std::vector<Box>& boxes, const std::vector<std::uint32_t>& parts) {
    const bool all_bounded =
        std::all_of(parts.begin(), parts.end(), [&](std::uint32_t part) { return boxes[part].is_bounded(); });
    return all_bounded ? build_grid(boxes, parts) : Grid{};
  }

  // Convex parts keep numbers below those of general ones.
  std::vector<std::uint32_t> renumber(const BoxHierarchy& hierarchy, std::size_t count) {
    constexpr std::uint32_t none = 0xffffffff;
    std::vector<std::uint32_t> new_number(count, none);
    const auto cells = static_cast<std::uint32_t>(convex_.size());
    for (std::uint32_t i = cells; i < count; ++i) new_number[i] = i;
    const auto place_next = [&](std::uint32_t part) {
      if (new_number[part] != none) return;
      new_number[part] = static_cast<std::uint32_t>(order_.size());
      order_.push_back(part);
    };
    for (const BoxNode& node : hierarchy.nodes)
      for (const std::uint32_t child : node.children)
        if (child >= BoxNode::first_part && child != BoxNode::no_child)
          place_next(child - BoxNode::first_part);
    for (std::uint32_t i = 0; i < cells; ++i) place_next(i);
    return new_number;
  }

  void report() {
    const auto dropped = [&](Simplification what, std::size_t count, const char* why) {
      if (count > 0) left_out_.push_back({what, count, why});
    };
    dropped(Simplification::duplicates, duplicates_, "operands written like an earlier one of the union");
    dropped(Simplification::empty_cells, empty_, "intersections without a point");
    dropped(Simplification::buried_parts, buried_, "cells inside a half-space of the union");
    dropped(Simplification::redundant_half_spaces, redundant_, "half-spaces that their cell does not reach");
    const std::size_t parts = parts_.size() - parts_.apart.size();
    if (parts_.hierarchy.nodes.empty())
      left_out_.push_back({Simplification::hierarchy, 0, "no index: so few parts are looked at one by one"});
    else
      left_out_.push_back({Simplification::hierarchy, parts, "parts in a hierarchy of boxes, eight abreast"});
    if (parts_.grid.rows > 0)
      left_out_.push_back({Simplification::grid, parts, "parts in squares as well, for short ranges"});
  }

  const Expression& solid_;
  const CompileOptions& options_;
  std::vector<LeftOut>& left_out_;
  std::vector<std::uint32_t> leaves_;
  std::vector<ConvexPart> convex_, general_;
  std::vector<std::uint32_t> order_;  // of the convex parts
  std::vector<HalfSpace> half_spaces_;
  std::vector<std::uint32_t> kept_;  // of one part
  std::unordered_map<std::size_t, std::uint32_t> first_leaf_by_hash_;
  Parts parts_;
  std::size_t duplicates_ = 0, empty_ = 0, buried_ = 0, redundant_ = 0;
};

}  // namespace

std::string_view name_of(Simplification simplification) {
  constexpr std::string_view names[number_of_simplifications] = {
      "constants",    "duplicates",      "empty-cells",   "buried-parts", "redundant-half-spaces",
      "hidden-rules", "known-materials", "remote-paints", "hierarchy",    "grid"};
  return names[static_cast<std::size_t>(simplification)];
}

Box box_around(const Expression& expression, const Node* node) {
  switch (node->kind) {
    case NodeKind::nothing:
      return nowhere;
    case NodeKind::everything:
      return {};
    case NodeKind::cell:
      return box_around({expression.leaves.data() + node->first_leaf, node->end_leaf - node->first_leaf});
    case NodeKind::union_of:
    case NodeKind::intersection_of:
      break;
  }
  const bool is_union = node->kind == NodeKind::union_of;
  Box box = is_union ? nowhere : Box{};
  for (const Node* operand = node + 1; operand != node + node->size; operand += operand->size) {
    const Box one = box_around(expression, operand);
    box = is_union ? hull(box, one) : intersection(box, one);
  }
  return box;
}

Parts divide(const Expression& solid, const CompileOptions& options, std::vector<LeftOut>& left_out) {
  return Divider(solid, options, left_out).result();
}

}  // namespace groundtruth::fast
