#pragma once
// Which face is met where several meet (SPEC section 3).

#include <array>

#include <groundtruth/tiers/naive/local_shape.hpp>

namespace groundtruth::tiers::naive {

// Directions around a point of a solid: the cone that the solid is there.
template <class Real>
class Cone {
 public:
  using Leaves = std::vector<const Node<Real>*>;

  Cone(const Local<Real>& local, const Leaves& standing) : local_(local), standing_(standing) {}

  // Does this leaf bound the solid? Its plane is cut into sectors by the other planes; each sector lies at
  // one of the sides of a line, so two directions beside every half of every line see all sectors.
  bool bounded_by(std::size_t leaf) const {
    const Vector3<Real>& n = standing_[leaf]->normal;
    bool has_lines = false;
    for (std::size_t other = 0; other < standing_.size(); ++other) {
      if (is_same_plane_as_written(leaf, other)) continue;
      const Vector3<Real> line = cross(n, standing_[other]->normal);
      if (is_zero(line)) continue;
      has_lines = true;
      for (const int half : {1, -1})
        for (const int side : {1, -1})
          if (bounds_beside({line, half, cross(n, line), side, other}, leaf)) return true;
    }
    if (has_lines) return false;
    const Vector3<Real> any = is_zero(Vector3<Real>{n.x, n.y, Real(0)})
                                  ? Vector3<Real>{Real(1), Real(0), Real(0)}
                                  : Vector3<Real>{Real(0) - n.y, n.x, Real(0)};
    return bounds_beside({any, 1, cross(n, any), 1, leaf}, leaf);
  }

  // Requires that no leaf bounds the solid: then it is all of space, or it has no inside.
  bool is_all_of_space() const {
    const Vector3<Real> along{Real(1), Real(0), Real(0)}, beside{Real(0), Real(1), Real(0)};
    const Vector3<Real> up{Real(0), Real(0), Real(1)};
    std::vector<Value> values;
    for (const Node<Real>* leaf : standing_) {
      int where = sign_of(dot(leaf->normal, along));
      if (where == 0) where = sign_of(dot(leaf->normal, beside));
      if (where == 0) where = sign_of(dot(leaf->normal, up));
      values.push_back(where <= 0 ? Value::in : Value::out);
    }
    return reduced(local_, values, standing_.size()).operation == Operation::everything;
  }

 private:
  // half * line, and a little of side * aside; `cut_by` is the leaf in whose plane the line lies.
  struct Direction {
    Vector3<Real> line;
    int half;
    Vector3<Real> aside;
    int side;
    std::size_t cut_by;
  };

  static bool is_zero(const Vector3<Real>& v) {
    return sign_of(v.x) == 0 && sign_of(v.y) == 0 && sign_of(v.z) == 0;
  }

  bool is_same_plane_as_written(std::size_t a, std::size_t b) const {
    return standing_[a]->written == standing_[b]->written;
  }

  // Of the leaf's distance at that direction; 0: its plane is that of `face`.
  int sign_at(const Direction& direction, std::size_t leaf, std::size_t face) const {
    if (is_same_plane_as_written(leaf, face)) return 0;
    const Vector3<Real>& n = standing_[leaf]->normal;
    const int on_line = is_same_plane_as_written(leaf, direction.cut_by)
                            ? 0
                            : direction.half * sign_of(dot(n, direction.line));
    return on_line != 0 ? on_line : direction.side * sign_of(dot(n, direction.aside));
  }

  bool bounds_beside(const Direction& direction, std::size_t leaf) const {
    std::vector<Value> in_plane, above, as_left;
    for (std::size_t other = 0; other < standing_.size(); ++other) {
      const int where = sign_at(direction, other, leaf);
      const Value value = where <= 0 ? Value::in : Value::out;
      const bool faces_alike = is_same_plane_as_written(other, leaf) ||
                               sign_of(dot(standing_[other]->normal, standing_[leaf]->normal)) > 0;
      in_plane.push_back(value);
      above.push_back(where != 0 ? value : faces_alike ? Value::out : Value::in);
      as_left.push_back(where == 0 ? Value::open : value);
    }
    return reduced(local_, in_plane, leaf).operation == Operation::everything &&
           reduced(local_, above, leaf).operation == Operation::nothing &&
           reduced(local_, as_left, leaf).has_wanted;
  }

  const Local<Real>& local_;
  const Leaves& standing_;
};

// More leaves than this stand at a point where arithmetic cannot tell planes apart: then the first that may be
// met is as good as any, and the time that an ask takes stays bounded.
inline constexpr std::size_t most_standing = 32;

// The canonical leaf at the first place of the solid; null: the place is interior.
template <class Real>
const Node<Real>* canonical_face(const Solid<Real>& solid, const Segment<Real>& segment,
                                 const Place<Real>& place) {
  std::vector<const Node<Real>*> standing;
  const Local<Real> local = local_shape(solid, 0, segment, place, standing);
  if (standing.size() < 2) return standing.empty() ? nullptr : standing.front();
  const Cone<Real> cone(local, standing);
  const bool at_start = place.plane == nullptr;
  const auto may_be_met = [&](const Node<Real>* leaf) {
    return at_start || sign_of(dot(leaf->normal, segment.direction())) < 0;
  };
  bool is_bounded = false;
  const bool is_hopeless = standing.size() > most_standing;
  for (std::size_t leaf = 0; leaf < standing.size() && !is_hopeless; ++leaf) {
    if (is_bounded && !may_be_met(standing[leaf])) continue;
    if (!cone.bounded_by(leaf)) continue;
    is_bounded = true;
    if (may_be_met(standing[leaf])) return standing[leaf];
  }
  if (at_start && !is_bounded && !is_hopeless && cone.is_all_of_space()) return nullptr;
  for (const Node<Real>* leaf : standing)
    if (may_be_met(leaf)) return leaf;
  return standing.front();
}

}  // namespace groundtruth::tiers::naive
