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
using LeafValues = boost::container::small_vector<Value, 512>;

using StandingLeaves = boost::container::small_vector<std::size_t, 64>;

inline std::size_t count_operands(const Node* node) {
  std::size_t count = 0;
  for (const Node* operand = node + 1; operand != node + node->size; operand += operand->size) ++count;
  return count;
}

// The leaves of a solid that stand at a point once it is simplified there.
class Standing {
 public:
  Standing(const ExpressionView& solid, const LeafValues& values) : solid_(solid), values_(values) {
    value_ = simplify(solid.nodes.data());
  }

  const ExpressionView& solid() const { return solid_; }
  const LeafValues& values() const { return values_; }
  Value value() const { return value_; }
  const StandingLeaves& leaves() const { return leaves_; }

 private:
  template <class AddNext>
  Value simplify_operands(NodeKind kind, std::size_t count, AddNext add_next) {
    const bool is_union = kind == NodeKind::union_of;
    const Value absorbing = is_union ? Value::everything : Value::nothing;
    const std::size_t before = leaves_.size();
    for (std::size_t i = 0; i < count; ++i) {
      if (add_next() != absorbing) continue;
      leaves_.resize(before);
      return absorbing;
    }
    if (leaves_.size() > before) return Value::open;
    return is_union ? Value::nothing : Value::everything;
  }

  // Collects the leaves that stand.
  Value simplify(const Node* node) {
    if (node->kind == NodeKind::nothing) return Value::nothing;
    if (node->kind == NodeKind::everything) return Value::everything;
    if (node->kind == NodeKind::cell) {
      std::size_t leaf = node->first_leaf;
      return simplify_operands(NodeKind::intersection_of, node->end_leaf - leaf, [&] {
        if (values_[leaf] == Value::open) leaves_.push_back(leaf);
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

  const ExpressionView& solid_;
  const LeafValues& values_;
  Value value_ = Value::open;
  StandingLeaves leaves_;
};

// Number: one that holds products of six components of normals.
template <class Number>
class Corner {
 public:
  // `normal_of(place)`: a positive multiple of the leaf's normal.
  template <class NormalOf>
  Corner(const Standing& standing, NormalOf normal_of)
      : solid_(standing.solid()),
        values_(standing.values()),
        value_(standing.value()),
        standing_(standing.leaves()) {
    for (const std::size_t leaf : standing_) normals_.push_back(normal_of(leaf));
    lines_.resize(normals_.size() * normals_.size());
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

  // In which one's plane cuts the other's: the product of their normals, computed when first asked for.
  struct Line {
    Normal<Number> direction;
    enum class Kind : std::uint8_t { unknown, none, line } kind = Kind::unknown;
  };
  const Line& line(std::size_t face, std::size_t other) const {
    Line& line = lines_[face * normals_.size() + other];
    if (line.kind == Line::Kind::unknown) {
      line.direction = cross(normals_[face], normals_[other]);
      const auto is_zero = [](const Number& x) { return sign(x) == 0; };
      const bool is_none = std::all_of(line.direction.begin(), line.direction.end(), is_zero);
      line.kind = is_none ? Line::Kind::none : Line::Kind::line;
    }
    return line;
  }
  bool have_one_plane(std::size_t face, std::size_t other) const {
    return line(face, other).kind == Line::Kind::none;
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
    const Normal<Number>& normal = normals_[leaf];
    if (!sector.other || have_one_plane(sector.face, leaf))
      return {true, sign(dot(normals_[sector.face], normal)) < 0, Value::open, leaf == sector.face};
    // n . v for v along the line; where that vanishes, for v turned away from it.
    const Normal<Number>& direction = line(sector.face, *sector.other).direction;
    int along = sign(dot(direction, normal));
    if (along == 0) along = -sign(dot(line(sector.face, leaf).direction, direction));
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

  const ExpressionView& solid_;
  const LeafValues& values_;
  const Value value_;
  const StandingLeaves& standing_;
  boost::container::small_vector<Normal<Number>, 8> normals_;  // of those that stand
  mutable boost::container::small_vector<Line, 64> lines_;     // by pairs
};

// Do the normals of all leaves that stand fit into so few bits that machine integers will do?
bool have_short_normals(const Standing& standing);

// A positive multiple of the leaf's normal. The second requires a short one.
Normal<Dyadic> dyadic_normal(const HalfSpace& leaf);
Normal<MachineInteger> machine_normal(const HalfSpace& leaf);

}  // namespace groundtruth::fast::exact_stage
