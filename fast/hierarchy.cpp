#include <groundtruth/fast/hierarchy.hpp>

#include <algorithm>
#include <cmath>
#include <span>

namespace groundtruth::fast {

namespace {

constexpr float greatest_float = std::numeric_limits<float>::max();

class HierarchyBuilder {
 public:
  HierarchyBuilder(const std::vector<Box>& boxes, BoxHierarchy& hierarchy)
      : boxes_(boxes), hierarchy_(hierarchy) {
    centres_.reserve(boxes.size());
    for (const Box& box : boxes) {
      Vector centre;
      for (std::size_t axis = 0; axis < 3; ++axis)
        centre[axis] = double{rounded_down(box.low[axis])} / 2 + double{rounded_up(box.high[axis])} / 2;
      centres_.push_back(centre);
    }
  }

  using Parts = std::span<std::uint32_t>;

  std::uint32_t build(Parts parts) {
    const auto place = static_cast<std::uint32_t>(hierarchy_.nodes.size());
    BoxNode empty;
    for (std::uint32_t child = 0; child < BoxNode::width; ++child) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        empty.low[axis][child] = greatest_float;
        empty.high[axis][child] = -greatest_float;
      }
      empty.children[child] = BoxNode::no_child;
    }
    hierarchy_.nodes.push_back(empty);
    std::uint32_t count = 0;
    divide(parts, capacity_below(parts.size()), [&](Parts some) {
      const std::uint32_t child = some.size() == 1 ? BoxNode::first_part + some.front() : build(some);
      Box box = nowhere;
      for (const std::uint32_t part : some) box = hull(box, boxes_[part]);
      BoxNode& node = hierarchy_.nodes[place];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        node.low[axis][count] = rounded_down(box.low[axis]);
        node.high[axis][count] = rounded_up(box.high[axis]);
      }
      node.children[count++] = child;
    });
    return place;
  }

 private:
  // Of each child of a node over so many parts, with all children but the last ones full.
  static std::size_t capacity_below(std::size_t parts) {
    std::size_t capacity = 1;
    while (capacity * BoxNode::width < parts) capacity *= BoxNode::width;
    return capacity;
  }

  // Cuts into pieces of `capacity` parts (one may have less) along the widest spread.
  template <class Visit>
  void divide(Parts parts, std::size_t capacity, const Visit& visit) {
    if (parts.size() <= capacity) return visit(parts);
    Vector low = nowhere.low, high = nowhere.high;
    for (const std::uint32_t part : parts)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], centres_[part][axis]);
        high[axis] = std::max(high[axis], centres_[part][axis]);
      }
    std::size_t widest = 0;
    for (const std::size_t axis : {std::size_t{1}, std::size_t{2}})
      if (high[axis] - low[axis] > high[widest] - low[widest]) widest = axis;
    const std::size_t half = (parts.size() + capacity - 1) / capacity / 2 * capacity;
    std::nth_element(
        parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(half), parts.end(),
        [&](std::uint32_t a, std::uint32_t b) { return centres_[a][widest] < centres_[b][widest]; });
    divide(parts.first(half), capacity, visit);
    divide(parts.subspan(half), capacity, visit);
  }

  const std::vector<Box>& boxes_;
  BoxHierarchy& hierarchy_;
  std::vector<Vector> centres_;
};

}  // namespace

float rounded_down(double x) {
  if (x >= double{greatest_float}) return greatest_float;
  if (x <= -double{greatest_float}) return -greatest_float;
  const auto rounded = static_cast<float>(x);
  return double{rounded} <= x ? rounded : std::nextafter(rounded, -greatest_float);
}

float rounded_up(double x) { return -rounded_down(-x); }

BoxHierarchy build_hierarchy(const std::vector<Box>& boxes, std::vector<std::uint32_t> parts) {
  BoxHierarchy hierarchy;
  if (!parts.empty()) HierarchyBuilder(boxes, hierarchy).build(parts);
  return hierarchy;
}

}  // namespace groundtruth::fast
