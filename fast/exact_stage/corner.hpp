#pragma once
// A solid near a point of its border, and which of its faces counts there (SPEC section 3). Not installed.

#include <algorithm>
#include <array>
#include <cstdint>

#include <groundtruth/fast/exact_stage/search.hpp>

namespace groundtruth::fast::exact_stage {

template <class Number>
using Normal = std::array<Number, 3>;

template <class Number>
Normal<Number> cross(const Normal<Number>& a, const Normal<Number>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class Number>
Number dot(const Normal<Number>& a, const Normal<Number>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

enum class Value : std::uint8_t { nothing, everything, open };

// What a leaf is near the point; open: the point lies in its plane.
using LeafValues = boost::container::small_vector<Value, 32>;

template <class Numbers>
class Corner {
 public:
  using Number = typename Numbers::Slope;

  // `normal_of(place)`: a positive multiple of the leaf's normal.
  template <class NormalOf>
  Corner(const Numbers& numbers, const ExpressionView& solid, const LeafValues& values, NormalOf normal_of)
      : numbers_(numbers), solid_(solid), values_(values) {
    value_ = simplify(solid.nodes.data());
    for (const std::size_t leaf : standing_) normals_.push_back(normal_of(leaf));
  }

  // Outward of some leaf of the corner there is, by a sector in its plane, whatever region is missing.
  bool is_interior() const {
    if (value_ != Value::open) return value_ == Value::everything;
    for (std::size_t face = 0; face < standing_.size(); ++face)
      if (some_view(face, [](const View& view) { return !view.outward; })) return false;
    return true;
  }

  // The place of the admissible leaf with the smallest number among those that satisfy the predicate.
  // Requires one that stands.
  template <class IsCandidate>
  std::size_t canonical_leaf(IsCandidate is_candidate) const {
    std::optional<std::size_t> bounding, any;
    for (std::size_t face = 0; face < standing_.size(); ++face) {
      const std::size_t leaf = standing_[face];
      if (!is_candidate(leaf)) continue;
      if (!any || number(leaf) < number(*any)) any = leaf;
      if (bounding && number(*bounding) < number(leaf)) continue;
      if (standing_.size() == 1 || bounds(face)) bounding = leaf;
    }
    return bounding ? *bounding : *any;
  }

 private:
  // The corner in the directions v of a sector: a part of a face's plane between lines in which other planes
  // cut it.
  struct View {
    bool at = false;                 // v itself belongs to it
    bool outward = false;            // v, turned a little outward from the face
    Value simplified = Value::open;  // with all leaves of other planes replaced by their values at v
    bool face_stands = false;        // the face is still there then
  };
  static constexpr View view_of(Value constant) {
    const bool is_all = constant == Value::everything;
    return {is_all, is_all, constant, false};
  }

  // v is just counterclockwise (seen from outside) of the line in which `other` cuts `face`, in one of its
  // directions. Without `other` no plane cuts the face.
  struct Sector {
    std::size_t face;
    std::optional<std::size_t> other;
    int turn;
  };

  std::size_t number(std::size_t leaf) const { return solid_.numbers.empty() ? leaf : solid_.numbers[leaf]; }

  template <class AddNext>
  Value simplify_operands(NodeKind kind, std::size_t count, AddNext add_next) {
    const bool is_union = kind == NodeKind::union_of;
    const Value absorbing = is_union ? Value::everything : Value::nothing;
    const std::size_t before = standing_.size();
    for (std::size_t i = 0; i < count; ++i) {
      if (add_next() != absorbing) continue;
      standing_.resize(before);
      return absorbing;
    }
    if (standing_.size() > before) return Value::open;
    return is_union ? Value::nothing : Value::everything;
  }

  // Collects the leaves that stand.
  Value simplify(const Node* node) {
    if (node->kind == NodeKind::nothing) return Value::nothing;
    if (node->kind == NodeKind::everything) return Value::everything;
    if (node->kind == NodeKind::cell) {
      std::size_t leaf = node->first_leaf;
      return simplify_operands(NodeKind::intersection_of, node->end_leaf - leaf, [&] {
        if (values_[leaf] == Value::open) standing_.push_back(leaf);
        return values_[leaf++];
      });
    }
    const Node* operand = node + 1;
    return simplify_operands(node->kind, count_operands(node), [&] {
      const Value value = simplify(operand);
      operand += operand->size;
      return value;
    });
  }

  static std::size_t count_operands(const Node* node) {
    std::size_t count = 0;
    for (const Node* operand = node + 1; operand != node + node->size; operand += operand->size) ++count;
    return count;
  }

  bool have_one_plane(std::size_t face, std::size_t other) const {
    const Normal<Number> line = cross(normals_[face], normals_[other]);
    return std::all_of(line.begin(), line.end(), [&](const Number& x) { return numbers_.sign(x) == 0; });
  }

  template <class Predicate>
  bool some_view(std::size_t face, Predicate predicate) const {
    bool is_cut = false;
    for (std::size_t other = 0; other < standing_.size(); ++other) {
      if (other == face || have_one_plane(face, other)) continue;
      is_cut = true;
      for (const int turn : {1, -1})
        if (predicate(view({face, other, turn}))) return true;
    }
    return !is_cut && predicate(view({face, std::nullopt, 1}));
  }

  bool bounds(std::size_t face) const {
    return some_view(face, [](const View& view) { return view.at && !view.outward && view.face_stands; });
  }

  View view(const Sector& sector) const {
    boost::container::small_vector<View, 16> views;
    for (std::size_t leaf = 0; leaf < standing_.size(); ++leaf) views.push_back(leaf_view(sector, leaf));
    return view(solid_.nodes.data(), views);
  }

  View leaf_view(const Sector& sector, std::size_t leaf) const {
    const Normal<Number>&face = normals_[sector.face], &normal = normals_[leaf];
    if (!sector.other || have_one_plane(sector.face, leaf))
      return {true, numbers_.sign(dot(face, normal)) < 0, Value::open, leaf == sector.face};
    // n . v for v along the line; where that vanishes, for v turned away from it.
    const Normal<Number>& other = normals_[*sector.other];
    int along = numbers_.sign(dot(face, cross(other, normal)));
    if (along == 0) along = -numbers_.sign(dot(cross(face, normal), cross(face, other)));
    return view_of(sector.turn * along < 0 ? Value::everything : Value::nothing);
  }

  template <class Views>
  View view(const Node* node, const Views& views) const {
    if (node->kind == NodeKind::nothing) return view_of(Value::nothing);
    if (node->kind == NodeKind::everything) return view_of(Value::everything);
    if (node->kind == NodeKind::cell) {
      std::size_t leaf = node->first_leaf;
      return combined(NodeKind::intersection_of, node->end_leaf - leaf,
                      [&] { return view_of_leaf(leaf++, views); });
    }
    const Node* operand = node + 1;
    return combined(node->kind, count_operands(node), [&] {
      const View one = view(operand, views);
      operand += operand->size;
      return one;
    });
  }

  template <class Views>
  View view_of_leaf(std::size_t leaf, const Views& views) const {
    if (values_[leaf] != Value::open) return view_of(values_[leaf]);
    const auto place = std::find(standing_.begin(), standing_.end(), leaf);
    // A leaf that does not stand is swallowed whatever it is.
    return place == standing_.end() ? View{} : views[static_cast<std::size_t>(place - standing_.begin())];
  }

  template <class Next>
  static View combined(NodeKind kind, std::size_t count, Next next) {
    const bool is_union = kind == NodeKind::union_of;
    const Value absorbing = is_union ? Value::everything : Value::nothing;
    View all = view_of(is_union ? Value::nothing : Value::everything);
    for (std::size_t i = 0; i < count; ++i) {
      const View one = next();
      if (one.simplified == absorbing) return one;
      all.at = is_union ? all.at || one.at : all.at && one.at;
      all.outward = is_union ? all.outward || one.outward : all.outward && one.outward;
      all.face_stands = all.face_stands || one.face_stands;
      if (one.simplified == Value::open) all.simplified = Value::open;
    }
    return all;
  }

  const Numbers& numbers_;
  const ExpressionView& solid_;
  const LeafValues& values_;
  Value value_ = Value::open;
  boost::container::small_vector<std::size_t, 16> standing_;
  boost::container::small_vector<Normal<Number>, 4> normals_;  // of those that stand
};

}  // namespace groundtruth::fast::exact_stage
