#include <groundtruth/exact/solid/faces.hpp>

#include <algorithm>
#include <stdexcept>

namespace groundtruth::exact {
namespace {

bool same_plane(const RationalVector& left, const RationalVector& right) {
  return is_zero(CGAL::cross_product(left, right));
}

bool same_side(const RationalVector& left, const RationalVector& right) { return sign(left * right) > 0; }

// Of a line through the origin in the plane with normal `axis`, the direction that comes first when one turns
// about the axis from `start`.
RationalVector first_direction(const RationalVector& line, const RationalVector& start,
                               const RationalVector& axis) {
  const RationalVector quarter = CGAL::cross_product(axis, start);
  const int side = sign(line * quarter);
  const bool first = side > 0 || (side == 0 && sign(line * start) > 0);
  return first ? line : RationalVector(-line);
}

class PointOnPlanes {
 public:
  PointOnPlanes(const Expression& cone, const std::vector<LocalLeaf>& leaves)
      : cone_(cone), leaves_(leaves) {}

  LocalFaces faces() const {
    std::vector<std::size_t> standing;
    for (const Node& node : cone_) {
      if (node.operation == Operation::leaf) standing.push_back(node.leaf);
    }
    std::vector<std::size_t> bounding;
    std::copy_if(standing.begin(), standing.end(), std::back_inserter(bounding),
                 [&](std::size_t i) { return bounds(i); });
    if (bounding.empty() && contains_a_generic_direction()) return {true, {}};
    std::vector<Leaf> admissible = those_that_count(bounding);
    if (admissible.empty()) admissible = those_that_count(standing);
    if (admissible.empty()) throw std::logic_error("exact: a border without a face");
    return {false, std::move(admissible)};
  }

 private:
  std::vector<Leaf> those_that_count(const std::vector<std::size_t>& places) const {
    std::vector<Leaf> leaves;
    for (const std::size_t i : places) {
      if (leaves_[i].counts) leaves.push_back(leaves_[i].leaf);
    }
    std::sort(leaves.begin(), leaves.end());
    return leaves;
  }

  bool bounds(std::size_t i) const {
    const std::vector<RationalVector> directions = sectors(i);
    return std::any_of(directions.begin(), directions.end(),
                       [&](const RationalVector& v) { return bounds_along(i, v); });
  }

  // SPEC section 3, "bounds", for one v: v is in the cone, v + eps n_i is not, and leaf i stands when the
  // leaves of other planes have their values at v.
  bool bounds_along(std::size_t i, const RationalVector& v) const {
    const auto truth_beside = [&](std::size_t j) {
      return sign(leaves_[j].normal * v) <= 0 ? Truth::yes : Truth::no;
    };
    const auto in_plane = [&](std::size_t j) { return same_plane(leaves_[i].normal, leaves_[j].normal); };
    const auto at_v = [&](std::size_t j) { return in_plane(j) ? Truth::yes : truth_beside(j); };
    const auto above_v = [&](std::size_t j) {
      if (!in_plane(j)) return truth_beside(j);
      return same_side(leaves_[i].normal, leaves_[j].normal) ? Truth::no : Truth::yes;
    };
    if (evaluate(cone_, 0, at_v) != Truth::yes || evaluate(cone_, 0, above_v) != Truth::no) return false;
    const auto of_other_planes = [&](std::size_t j) {
      return in_plane(j) ? Truth::unknown : truth_beside(j);
    };
    const Expression rest = reduced(cone_, of_other_planes);
    return std::any_of(rest.begin(), rest.end(),
                       [&](const Node& node) { return node.operation == Operation::leaf && node.leaf == i; });
  }

  // One direction in each sector into which the other planes cut the plane of leaf i; where none cuts it,
  // one.
  std::vector<RationalVector> sectors(std::size_t i) const {
    const RationalVector& axis = leaves_[i].normal;
    std::vector<RationalVector> lines;
    for (const LocalLeaf& other : leaves_) {
      const RationalVector line = CGAL::cross_product(axis, other.normal);
      if (is_zero(line)) continue;
      lines.push_back(lines.empty() ? line : first_direction(line, lines.front(), axis));
    }
    if (lines.empty()) return {RationalVector(CGAL::NULL_VECTOR)};
    const auto turns_before = [&](const RationalVector& left, const RationalVector& right) {
      return sign(CGAL::cross_product(left, right) * axis) > 0;
    };
    std::sort(lines.begin(), lines.end(), turns_before);
    lines.erase(std::unique(lines.begin(), lines.end(), same_plane), lines.end());
    if (lines.size() == 1) {
      const RationalVector across = CGAL::cross_product(axis, lines.front());
      return {across, -across};
    }
    std::vector<RationalVector> between;
    lines.push_back(-lines.front());
    for (std::size_t k = 0; k + 1 < lines.size(); ++k) {
      const RationalVector middle = lines[k] + lines[k + 1];
      between.push_back(middle);
      between.push_back(-middle);
    }
    return between;
  }

  // A plane through the origin holds at most two of the directions (1, t, t^2).
  bool contains_a_generic_direction() const {
    for (int t = 0;; ++t) {
      const RationalVector v(1, t, t * t);
      const bool generic = std::none_of(leaves_.begin(), leaves_.end(),
                                        [&](const LocalLeaf& leaf) { return sign(leaf.normal * v) == 0; });
      if (!generic) continue;
      const auto truth = [&](std::size_t j) {
        return sign(leaves_[j].normal * v) < 0 ? Truth::yes : Truth::no;
      };
      return evaluate(cone_, 0, truth) == Truth::yes;
    }
  }

  const Expression& cone_;
  const std::vector<LocalLeaf>& leaves_;
};

}  // namespace

LocalFaces faces_at(const Expression& cone, const std::vector<LocalLeaf>& leaves) {
  return PointOnPlanes(cone, leaves).faces();
}

}  // namespace groundtruth::exact
