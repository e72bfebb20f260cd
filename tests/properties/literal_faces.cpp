#include <groundtruth/tests/properties/literal_faces.hpp>

#include <algorithm>
#include <functional>

namespace groundtruth::properties {
namespace {

using Direction = std::array<int, 3>;

int dot(const Direction& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

bool parallel(const Direction& a, const Direction& b) {
  return a[1] * b[2] == a[2] * b[1] && a[2] * b[0] == a[0] * b[2] && a[0] * b[1] == a[1] * b[0];
}

std::vector<Direction> lattice(int largest) {
  std::vector<Direction> directions;
  for (int x = -largest; x <= largest; ++x)
    for (int y = -largest; y <= largest; ++y)
      for (int z = -largest; z <= largest; ++z) directions.push_back({x, y, z});
  return directions;
}

enum class Value { nothing, everything, leaf };
using ValueOfLeaf = std::function<Value(Leaf)>;

// What is left of an expression once constants are simplified away.
struct Simplified {
  Value value = Value::nothing;  // leaf: an expression of the leaves that stand
  std::vector<Leaf> standing;
};

Simplified simplified(const Shape& shape, const ValueOfLeaf& value_of, Leaf& next_leaf) {
  if (std::holds_alternative<Everything>(shape.expression)) return {Value::everything, {}};
  if (std::holds_alternative<Nothing>(shape.expression)) return {Value::nothing, {}};
  if (std::holds_alternative<HalfSpace>(shape.expression)) {
    const Leaf leaf = next_leaf++;
    const Value value = value_of(leaf);
    return {value, value == Value::leaf ? std::vector<Leaf>{leaf} : std::vector<Leaf>{}};
  }
  if (const auto* c = std::get_if<Covered>(&shape.expression))
    return simplified(*c->over, value_of, next_leaf);
  if (const auto* p = std::get_if<Painted>(&shape.expression))
    return simplified(*p->over, value_of, next_leaf);
  const auto* united = std::get_if<Union>(&shape.expression);
  const auto& operands = united ? united->operands : std::get<Intersection>(shape.expression).operands;
  const Value swallowing = united ? Value::everything : Value::nothing;
  Simplified result{united ? Value::nothing : Value::everything, {}};
  bool swallowed = false;
  for (const Shape& operand : operands) {
    const Simplified part = simplified(operand, value_of, next_leaf);
    swallowed = swallowed || part.value == swallowing;
    if (part.value == Value::leaf) result.value = Value::leaf;
    result.standing.insert(result.standing.end(), part.standing.begin(), part.standing.end());
  }
  if (swallowed) return {swallowing, {}};
  return result;
}

class Place {
 public:
  Place(const Shape& shape, const Point& x) : shape_(shape) {
    for (const HalfSpace& h : leaves_of(shape)) {
      const Direction n{static_cast<int>(h.normal[0]), static_cast<int>(h.normal[1]),
                        static_cast<int>(h.normal[2])};
      const int side = delta(h, x).sign();
      normals_.push_back(n);
      off_plane_.push_back(side <= 0 ? Value::everything : Value::nothing);
      in_a_.push_back(side == 0 && n != Direction{});
    }
  }

  bool interior() const {
    static const std::vector<Direction> everywhere = lattice(6);
    return std::all_of(everywhere.begin(), everywhere.end(),
                       [this](const Direction& v) { return in_cone(v, Direction{}); });
  }

  bool bounds(Leaf i) const {
    static const std::vector<Direction> directions = lattice(4);
    if (!in_a_[i]) return false;
    return std::any_of(directions.begin(), directions.end(), [&](const Direction& v) {
      if (dot(normals_[i], v) != 0) return false;
      for (Leaf j = 0; j < normals_.size(); ++j)
        if (in_a_[j] && !parallel(normals_[i], normals_[j]) && dot(normals_[j], v) == 0) return false;
      if (!in_cone(v, Direction{}) || in_cone(v, normals_[i])) return false;
      return stands(i, [&](Leaf j) {
        if (!in_a_[j]) return off_plane_[j];
        if (parallel(normals_[i], normals_[j])) return Value::leaf;
        return dot(normals_[j], v) <= 0 ? Value::everything : Value::nothing;
      });
    });
  }

  bool stands_here(Leaf i) const {
    return in_a_[i] && stands(i, [this](Leaf j) { return in_a_[j] ? Value::leaf : off_plane_[j]; });
  }

  bool entered(Leaf i, const Point& from, const Point& to) const {
    const auto& n = normals_[i];
    return n[0] * (to[0] - from[0]) + n[1] * (to[1] - from[1]) + n[2] * (to[2] - from[2]) < 0;
  }

  std::size_t leaves() const { return normals_.size(); }

 private:
  // Is v + eps u in L, for small eps > 0?
  bool in_cone(const Direction& v, const Direction& u) const {
    Leaf next_leaf = 0;
    const auto value = [&](Leaf j) {
      if (!in_a_[j]) return off_plane_[j];
      const int first = dot(normals_[j], v);
      const int side = first != 0 ? first : dot(normals_[j], u);
      return side <= 0 ? Value::everything : Value::nothing;
    };
    return simplified(shape_, value, next_leaf).value == Value::everything;
  }

  bool stands(Leaf i, const ValueOfLeaf& value_of) const {
    Leaf next_leaf = 0;
    const std::vector<Leaf> standing = simplified(shape_, value_of, next_leaf).standing;
    return std::find(standing.begin(), standing.end(), i) != standing.end();
  }

  const Shape& shape_;
  std::vector<Direction> normals_;
  std::vector<Value> off_plane_;  // of leaves not in A
  std::vector<bool> in_a_;
};

}  // namespace

LiteralFaces literal_faces(const Shape& shape, const EntryAsk& ask, const Rational& lambda) {
  const Place place(shape, point_at(ask, lambda));
  const bool starts_here = lambda == Rational(ask.lambda_first);
  if (starts_here && place.interior()) return {true, {}};
  const Point from = point(ask.from), to = point(ask.to);
  const auto those = [&](const auto& qualifies) {
    std::vector<Leaf> leaves;
    for (Leaf i = 0; i < place.leaves(); ++i)
      if (qualifies(i) && (starts_here || place.entered(i, from, to))) leaves.push_back(i);
    return leaves;
  };
  const std::vector<Leaf> bounding = those([&](Leaf i) { return place.bounds(i); });
  if (!bounding.empty()) return {false, bounding};
  return {false, those([&](Leaf i) { return place.stands_here(i); })};
}

}  // namespace groundtruth::properties
