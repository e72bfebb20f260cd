#include <groundtruth/fast/divide.hpp>

#include <algorithm>
#include <span>
#include <string_view>

#include <groundtruth/fast/cell_kernels.hpp>
#include <groundtruth/fast/part_index.hpp>
#include <groundtruth/fast/written_cells.hpp>

namespace groundtruth::fast {

namespace {

// More half-spaces than this that are operands of the union are not held against every cell.
constexpr std::size_t most_grounds = 8;

class Divider {
 public:
  Divider(const Expression& solid, const CompileOptions& options, std::vector<LeftOut>& left_out)
      : solid_(solid), options_(options), left_out_(left_out) {}

  Parts result() {
    parts_.kernels =
        options_.instructions() == Instructions::portable ? &portable_cell_kernels : &best_cell_kernels();
    add_operands();
    if (has(Simplification::buried_parts)) drop_buried();
    const std::size_t cell_count = convex_.size();
    boxes_.insert(boxes_.end(), general_boxes_.begin(), general_boxes_.end());
    PartIndex index = index_parts(boxes_, cell_count, options_);
    pack(index.cells);
    parts_.apart = std::move(index.apart);
    parts_.hierarchy = std::move(index.hierarchy);
    parts_.grid = std::move(index.grid);
    report();
    return std::move(parts_);
  }

 private:
  bool has(Simplification simplification) const { return options_.has(simplification); }

  void add_operands() {
    const Node* root = solid_.nodes.data();
    const bool is_union = root->kind == NodeKind::union_of;
    const Node *first = is_union ? root + 1 : root, *end = root + root->size;
    std::size_t count = 0;
    for (const Node* operand = first; operand != end; operand += operand->size) ++count;
    convex_.reserve(count);
    boxes_.reserve(count);
    WrittenCells written(has(Simplification::duplicates) ? count : 0);
    for (const Node* operand = first; operand != end; operand += operand->size) add(operand, written);
  }

  static bool is_convex(const Node* node) {
    if (node->kind == NodeKind::cell) return true;
    if (node->kind != NodeKind::intersection_of) return false;
    return std::all_of(node + 1, node + node->size, [](const Node& n) { return n.kind == NodeKind::cell; });
  }

  void add(const Node* node, WrittenCells& written) {
    if (node->kind == NodeKind::nothing) return;
    const auto place = static_cast<std::uint32_t>(node - solid_.nodes.data());
    if (!is_convex(node)) {
      parts_.general.push_back(place);
      general_boxes_.push_back(box_around(solid_, node));
      return;
    }
    const auto half_spaces = half_spaces_of(place, half_spaces_);
    const auto of_another = [&](std::uint32_t number) { return half_spaces_of(number, of_another_); };
    if (has(Simplification::duplicates) && written.has_or_add(half_spaces, place, of_another)) {
      ++duplicates_;
      return;
    }
    const Box box = box_around(half_spaces);
    if (has(Simplification::empty_cells) && box.is_empty()) {
      ++empty_;
      return;
    }
    convex_.push_back(place);
    boxes_.push_back(box);
  }

  // Of a convex node; in `room`, if they do not stand side by side.
  std::span<const HalfSpace> half_spaces_of(std::uint32_t place, std::vector<HalfSpace>& room) const {
    const Node* node = solid_.nodes.data() + place;
    const auto of_cell = [&](const Node& cell) {
      return std::span(solid_.leaves).subspan(cell.first_leaf, cell.end_leaf - cell.first_leaf);
    };
    if (node->size == 1) return of_cell(*node);
    room.clear();
    for (const Node* cell = node + 1; cell != node + node->size; ++cell)
      room.insert(room.end(), of_cell(*cell).begin(), of_cell(*cell).end());
    return room;
  }

  // A point of a cell strictly inside a half-space of the union is interior, whatever the cell says.
  void drop_buried() {
    std::vector<HalfSpace> grounds;
    for (const std::uint32_t place : convex_) {
      const auto half_spaces = half_spaces_of(place, half_spaces_);
      if (half_spaces.size() == 1) grounds.push_back(half_spaces.front());
    }
    if (grounds.size() > most_grounds) return;
    std::size_t kept = 0;
    for (std::size_t i = 0; i != convex_.size(); ++i) {
      const bool is_buried = std::ranges::any_of(
          grounds, [&](const HalfSpace& ground) { return greatest_delta(ground, boxes_[i]) < 0; });
      if (is_buried) continue;
      convex_[kept] = convex_[i];
      boxes_[kept++] = boxes_[i];
    }
    buried_ = convex_.size() - kept;
    convex_.resize(kept);
    boxes_.resize(kept);
  }

  void pack(const std::vector<std::uint32_t>& order) {
    std::size_t groups = 0;
    for (const std::uint32_t place : convex_) groups += (half_spaces_of(place, half_spaces_).size() + 3) / 4;
    parts_.cells.cells.reserve(order.size());
    parts_.cells.groups.reserve(groups);
    for (const std::uint32_t number : order) pack_cell(number);
    parts_.cells.groups.shrink_to_fit();
    parts_.cells.leaves.shrink_to_fit();
  }

  void pack_cell(std::uint32_t number) {
    kept_.clear();
    const Node* node = solid_.nodes.data() + convex_[number];
    for (const Node* cell = node; cell != node + node->size; ++cell)
      for (std::uint32_t leaf = cell->first_leaf; leaf != cell->end_leaf; ++leaf) kept_.push_back(leaf);
    for (std::size_t i = 0; i < kept_.size();) {
      std::size_t* const reason = reason_to_drop(boxes_[number], i);
      if (reason) {
        ++*reason;
        kept_.erase(kept_.begin() + static_cast<std::ptrdiff_t>(i));
      } else {
        ++i;
      }
    }
    half_spaces_.clear();
    for (const std::uint32_t leaf : kept_) half_spaces_.push_back(solid_.leaves[leaf]);
    parts_.cells.add(kept_, half_spaces_);
  }

  // Null: kept_[i] must stay. Of equal leaves the first is canonical. A plane beyond a box that the others
  // span is met by no point of the cell; only oblique ones are looked at: the others span the box themselves.
  std::size_t* reason_to_drop(const Box& box, std::size_t i) {
    const HalfSpace& half_space = solid_.leaves[kept_[i]];
    const auto is_written_alike = [&](std::uint32_t leaf) { return solid_.leaves[leaf] == half_space; };
    if (has(Simplification::duplicates) &&
        std::any_of(kept_.begin(), kept_.begin() + static_cast<std::ptrdiff_t>(i), is_written_alike))
      return &duplicates_;
    const auto& n = half_space.normal;
    const int axes = (n[0] != 0) + (n[1] != 0) + (n[2] != 0);
    if (!has(Simplification::redundant_half_spaces) || axes < 2 || !(greatest_delta(half_space, box) < 0))
      return nullptr;
    half_spaces_.clear();
    for (std::size_t other = 0; other < kept_.size(); ++other)
      if (other != i) half_spaces_.push_back(solid_.leaves[kept_[other]]);
    return greatest_delta(half_space, box_around(half_spaces_)) < 0 ? &redundant_ : nullptr;
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
  std::vector<std::uint32_t> convex_;  // where they start in the solid's nodes
  LargeVector<Box> boxes_;
  std::vector<Box> general_boxes_;
  std::vector<HalfSpace> half_spaces_, of_another_;  // of one part
  std::vector<std::uint32_t> kept_;                  // of one part
  Parts parts_;
  std::size_t duplicates_ = 0, empty_ = 0, buried_ = 0, redundant_ = 0;
};

}  // namespace

std::string_view name_of(Simplification simplification) {
  constexpr std::string_view names[number_of_simplifications] = {
      "constants",    "duplicates",      "empty-cells",   "buried-parts", "redundant-half-spaces",
      "hidden-rules", "known-materials", "remote-paints", "hierarchy",    "grid",
      "written-solid"};
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
