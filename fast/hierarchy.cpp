#include <groundtruth/fast/hierarchy.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include <boost/container/static_vector.hpp>
#include <groundtruth/fast/lanes.hpp>

namespace groundtruth::fast {

namespace {

// Few scenes have more nodes than this lets expect.
constexpr std::size_t usual_parts_per_node = 4;
constexpr float greatest_float = std::numeric_limits<float>::max();

using Corner = OneVector<FourFloats>;  // x, y, z, and nothing

// Grows from nothing.
struct FloatBox {
  Corner low = Corner::all(greatest_float);
  Corner high = Corner::all(-greatest_float);

  void add(const FloatBox& other) {
    low = lesser(low, other.low);
    high = greater(high, other.high);
  }
  // What the chance of a range to meet it goes by.
  double half_area() const {
    const auto width = [&](int axis) { return double{high[axis]} - double{low[axis]}; };
    return width(0) * width(1) + width(1) * width(2) + width(2) * width(0);
  }
};

struct BoxedPart {
  FloatBox box;
  std::uint32_t part;

  Corner centre() const { return box.low * Corner::all(0.5F) + box.high * Corner::all(0.5F); }
};

using BoxedParts = std::span<BoxedPart>;

struct Piece {
  BoxedParts parts;
  FloatBox box;
};

FloatBox box_of(BoxedParts parts) {
  FloatBox box;
  for (const BoxedPart& one : parts) box.add(one.box);
  return box;
}

// Cuts parts in two where their boxes' areas, each times the number of its parts, make the least sum: by the
// surface area heuristic, at the borders of equal bins of their centres.
class Cutter {
 public:
  explicit Cutter(BoxedParts parts) : parts_(parts) {
    FloatBox centres;
    for (const BoxedPart& one : parts) centres.add({one.centre(), one.centre()});
    low_ = centres.low;
    for (int axis = 0; axis < 3; ++axis) {
      const float width = centres.high[axis] - low_[axis];
      if (width > 0) scale_.vector[axis] = static_cast<float>(bins) * (1 - 0x1p-20F) / width;
      if (width > centres.high[widest_] - low_[widest_]) widest_ = axis;
    }
  }

  // Neither piece is empty.
  std::pair<Piece, Piece> cut() {
    fill_bins();
    const std::optional<Cut> best = best_cut();
    if (!best) return cut_in_halves();
    const auto middle = std::partition(parts_.begin(), parts_.end(), [&](const BoxedPart& one) {
      return bin_of(one)[best->axis] <= best->last_bin;
    });
    const auto first = static_cast<std::size_t>(middle - parts_.begin());
    return {{parts_.first(first), best->first}, {parts_.subspan(first), best->second}};
  }

  // Of as many parts each, along the axis of the widest spread.
  std::pair<Piece, Piece> cut_in_halves() {
    const std::size_t half = parts_.size() / 2;
    std::nth_element(
        parts_.begin(), parts_.begin() + static_cast<std::ptrdiff_t>(half), parts_.end(),
        [&](const BoxedPart& a, const BoxedPart& b) { return a.centre()[widest_] < b.centre()[widest_]; });
    const BoxedParts first = parts_.first(half), second = parts_.subspan(half);
    return {{first, box_of(first)}, {second, box_of(second)}};
  }

 private:
  static constexpr int bins = 16;

  struct Bin {
    FloatBox box;
    std::uint32_t count = 0;

    void add(const Bin& other) {
      box.add(other.box);
      count += other.count;
    }
    double cost() const { return count == 0 ? 0 : box.half_area() * count; }
  };
  struct Cut {
    int axis, last_bin;  // of the first piece
    FloatBox first, second;
  };

  // The first one if it is no number: a width that overflows, or is too small to divide by.
  V4i bin_of(const BoxedPart& one) const {
    const Corner bin = greater((one.centre() - low_) * scale_, Corner::all(0));
    return __builtin_convertvector(lesser(bin, Corner::all(bins - 1)).vector, V4i);
  }

  void fill_bins() {
    for (const BoxedPart& one : parts_) {
      const V4i bin = bin_of(one);
      for (int axis = 0; axis < 3; ++axis) bins_[axis][bin[axis]].add({one.box, 1});
    }
  }

  std::optional<Cut> best_cut() const {
    std::optional<Cut> best;
    double least = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      Bin behind[bins];  // each bin and all behind it
      for (int i = bins - 1; i > 0; --i) {
        behind[i] = bins_[axis][i];
        if (i + 1 < bins) behind[i].add(behind[i + 1]);
      }
      Bin before;
      for (int i = 0; i + 1 < bins; ++i) {
        before.add(bins_[axis][i]);
        const double cost = before.cost() + behind[i + 1].cost();
        if (before.count == 0 || behind[i + 1].count == 0 || !(cost < least)) continue;
        least = cost;
        best = {axis, i, before.box, behind[i + 1].box};
      }
    }
    return best;
  }

  BoxedParts parts_;
  Corner low_, scale_ = Corner::all(0);
  int widest_ = 0;
  Bin bins_[3][bins];
};

class HierarchyBuilder {
 public:
  explicit HierarchyBuilder(LargeVector<BoxNode>& nodes) : nodes_(nodes) {}

  std::uint32_t build(const Piece& all, std::uint32_t depth) {
    const Pieces pieces = cut(all, depth);
    const auto place = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back(empty_node());
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
      const auto& [parts, box] = pieces[i];
      const std::uint32_t child =
          parts.size() == 1 ? BoxNode::first_part + parts.front().part : build(pieces[i], depth + 1);
      BoxNode& node = nodes_[place];
      for (int axis = 0; axis < 3; ++axis) {
        node.low[axis][i] = box.low[axis];
        node.high[axis][i] = box.high[axis];
      }
      node.children[i] = child;
    }
    return place;
  }

 private:
  using Pieces = boost::container::static_vector<Piece, BoxNode::width>;

  // What fills a node of its own is not cut, but where there is room for all its parts: full nodes are few.
  static Pieces cut(const Piece& all, std::uint32_t depth) {
    Pieces pieces{all};
    while (pieces.size() < BoxNode::width) {
      Piece* const next = largest_too_large_for_a_node(pieces);
      if (next == nullptr) break;
      Cutter cutter(next->parts);
      Piece other;
      std::tie(*next, other) = depth < BoxNode::most_uneven_depth ? cutter.cut() : cutter.cut_in_halves();
      pieces.push_back(other);
    }
    while (Piece* const next = most_parts_with_room(pieces)) {
      const BoxedParts parts = next->parts;
      *next = {parts.first(1), parts.front().box};
      for (std::size_t i = 1; i < parts.size(); ++i) pieces.push_back({parts.subspan(i, 1), parts[i].box});
    }
    return pieces;
  }

  static Piece* largest_too_large_for_a_node(Pieces& pieces) {
    Piece* best = nullptr;
    double largest = -1;
    for (Piece& piece : pieces) {
      const double area = piece.box.half_area();
      if (piece.parts.size() <= BoxNode::width || !(area > largest)) continue;
      best = &piece;
      largest = area;
    }
    return best;
  }

  static Piece* most_parts_with_room(Pieces& pieces) {
    const std::size_t room = BoxNode::width - pieces.size() + 1;
    Piece* best = nullptr;
    for (Piece& piece : pieces) {
      const std::size_t size = piece.parts.size();
      if (size >= 2 && size <= room && (best == nullptr || size > best->parts.size())) best = &piece;
    }
    return best;
  }

  static BoxNode empty_node() {
    BoxNode node;
    for (std::uint32_t child = 0; child < BoxNode::width; ++child) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        node.low[axis][child] = greatest_float;
        node.high[axis][child] = -greatest_float;
      }
      node.children[child] = BoxNode::no_child;
    }
    return node;
  }

  LargeVector<BoxNode>& nodes_;
};

FloatBox rounded_outwards(const Box& box) {
  FloatBox rounded;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    rounded.low.vector[axis] = rounded_down(box.low[axis]);
    rounded.high.vector[axis] = rounded_up(box.high[axis]);
  }
  return rounded;
}

}  // namespace

float rounded_down(double x) {
  if (x >= double{greatest_float}) return greatest_float;
  if (x <= -double{greatest_float}) return -greatest_float;
  const auto rounded = static_cast<float>(x);
  return double{rounded} <= x ? rounded : std::nextafter(rounded, -greatest_float);
}

float rounded_up(double x) { return -rounded_down(-x); }

BoxHierarchy build_hierarchy(std::span<const Box> boxes, const std::vector<std::uint32_t>& parts) {
  BoxHierarchy hierarchy;
  if (parts.empty()) return hierarchy;
  LargeVector<BoxedPart> boxed;
  boxed.reserve(parts.size());
  for (const std::uint32_t part : parts) boxed.push_back({rounded_outwards(boxes[part]), part});
  hierarchy.nodes.reserve(parts.size() / usual_parts_per_node + 1);
  HierarchyBuilder(hierarchy.nodes).build({boxed, box_of(boxed)}, 0);
  return hierarchy;
}

}  // namespace groundtruth::fast
