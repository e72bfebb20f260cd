#include <groundtruth/fast/part_index.hpp>

#include <algorithm>

namespace groundtruth::fast {

namespace {

// More parts without a bounded box than this are not looked at one by one.
constexpr std::size_t most_unbounded_parts = 8;
constexpr std::size_t fewest_parts_for_hierarchy = 5;

// Which parts an index holds, and which are looked at one by one, by their old numbers.
struct Shares {
  std::vector<std::uint32_t> indexed, apart;
  bool all_bounded = true;  // those that are indexed
};

Shares share_out(std::span<const Box> boxes, const CompileOptions& options) {
  Shares shares;
  const auto count = static_cast<std::uint32_t>(boxes.size());
  shares.indexed.reserve(count);
  for (std::uint32_t i = 0; i != count; ++i)
    (boxes[i].is_bounded() ? shares.indexed : shares.apart).push_back(i);
  if (shares.apart.size() > most_unbounded_parts) {
    shares.indexed.insert(shares.indexed.end(), shares.apart.begin(), shares.apart.end());
    shares.apart.clear();
    shares.all_bounded = false;
  }
  // An empty box is met nowhere; hulls do not know it.
  std::erase_if(shares.indexed, [&](std::uint32_t i) { return boxes[i].is_empty(); });
  if (options.has(Simplification::hierarchy) && count >= fewest_parts_for_hierarchy &&
      !shares.indexed.empty())
    return shares;
  shares.indexed.clear();
  shares.apart.clear();
  for (std::uint32_t i = 0; i != count; ++i) shares.apart.push_back(i);
  return shares;
}

bool is_part(std::uint32_t child) { return child >= BoxNode::first_part && child != BoxNode::no_child; }

// Cells keep numbers below those of the others.
std::vector<std::uint32_t> renumber(PartIndex& index, std::size_t part_count, std::size_t cell_count) {
  constexpr std::uint32_t none = 0xffffffff;
  std::vector<std::uint32_t> new_number(part_count, none);
  for (std::size_t i = cell_count; i < part_count; ++i) new_number[i] = static_cast<std::uint32_t>(i);
  index.cells.reserve(cell_count);
  const auto place_next = [&](std::uint32_t part) {
    if (new_number[part] != none) return;
    new_number[part] = static_cast<std::uint32_t>(index.cells.size());
    index.cells.push_back(part);
  };
  for (BoxNode& node : index.hierarchy.nodes)
    for (std::uint32_t& child : node.children) {
      if (!is_part(child)) continue;
      place_next(child - BoxNode::first_part);
      child = BoxNode::first_part + new_number[child - BoxNode::first_part];
    }
  for (std::uint32_t i = 0; i < cell_count; ++i) place_next(i);
  return new_number;
}

}  // namespace

PartIndex index_parts(std::span<const Box> boxes, std::size_t cell_count, const CompileOptions& options) {
  PartIndex index;
  const Shares shares = share_out(boxes, options);
  index.hierarchy = build_hierarchy(boxes, shares.indexed);
  if (options.has(Simplification::grid) && shares.all_bounded) index.grid = build_grid(boxes, shares.indexed);
  const std::vector<std::uint32_t> new_number = renumber(index, boxes.size(), cell_count);
  for (GridEntry& entry : index.grid.entries) entry.part = new_number[entry.part];
  for (const std::uint32_t part : shares.apart) index.apart.push_back(new_number[part]);
  return index;
}

}  // namespace groundtruth::fast
