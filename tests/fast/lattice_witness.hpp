#pragma once
// SPEC section 3 word by word for half-spaces and segments with small integers, in integers, by enumeration:
// all crossings are tried, and directions are taken from a lattice. Slow, and nothing like fast's own ways.
//
// The lattice is fine enough for normals in {-1, 0, 1}^3: planes through a point then meet in lines along
// vectors with entries up to 2, and the sum of the three lines that bound a region has entries up to 6.

#include <algorithm>
#include <cstdint>
#include <functional>
#include <numeric>
#include <set>
#include <vector>

#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/ask.hpp>
#include <groundtruth/problem/scene.hpp>

namespace groundtruth::lattice {

using Integer = std::int64_t;
using Direction = std::array<Integer, 3>;

inline Integer integer(double x) { return static_cast<Integer>(x); }
inline Direction integers(const Vector& v) { return {integer(v[0]), integer(v[1]), integer(v[2])}; }
inline Integer dot(const Direction& a, const Direction& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), Integer{0});
}
inline int sign(Integer x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }
inline bool are_parallel(const Direction& a, const Direction& b) {
  return a[1] * b[2] == a[2] * b[1] && a[2] * b[0] == a[0] * b[2] && a[0] * b[1] == a[1] * b[0];
}

// lambda = numerator / denominator, denominator > 0.
struct Fraction {
  Integer numerator = 0;
  Integer denominator = 1;
  bool operator<(const Fraction& other) const {
    return numerator * other.denominator < other.numerator * denominator;
  }
  double value() const { return static_cast<double>(numerator) / static_cast<double>(denominator); }
};

class Witness {
 public:
  // The ask's range must be of multiples of 1/4.
  Witness(const groundtruth::Scene& scene, const EntryAsk& ask)
      : shape_(scene.shape), ask_(ask), from_(integers(ask.from)), to_(integers(ask.to)) {
    collect(shape_);
  }

  EntryAnswer answer() {
    const Fraction first{integer(4 * ask_.lambda_first), 4}, last{integer(4 * ask_.lambda_last), 4};
    std::vector<Fraction> candidates{first};
    for (const HalfSpace& leaf : leaves_)
      if (const Integer a = delta(leaf, from_), b = delta(leaf, to_); a != b)
        candidates.push_back(a > b ? Fraction{a, a - b} : Fraction{-a, b - a});
    std::sort(candidates.begin(), candidates.end());
    for (const Fraction& lambda : candidates) {
      if (lambda < first || last < lambda || !is_member(shape_, lambda)) continue;
      lambda_ = lambda;
      return at_lambda(!(first < lambda));
    }
    return Miss{};
  }

 private:
  static Integer delta(const HalfSpace& leaf, const Direction& x) {
    return dot(integers(leaf.normal), x) - integer(leaf.offset);
  }
  int sign_at(const HalfSpace& leaf, const Fraction& lambda) const {
    const Integer a = delta(leaf, from_), b = delta(leaf, to_);
    return sign(a * lambda.denominator + lambda.numerator * (b - a));
  }

  // The leaves that stand, and the value if none does.
  struct Simplified {
    bool value = false;
    std::set<Leaf> standing;
  };
  enum class LeafValue { no, yes, kept };
  using LeafValues = std::function<LeafValue(Leaf)>;

  static Simplified simplify(const Shape& shape, Leaf& next, const LeafValues& values) {
    if (std::holds_alternative<Everything>(shape.expression)) return {true, {}};
    if (std::holds_alternative<HalfSpace>(shape.expression)) {
      const Leaf leaf = next++;
      const LeafValue value = values(leaf);
      return value == LeafValue::kept ? Simplified{false, {leaf}} : Simplified{value == LeafValue::yes, {}};
    }
    if (const auto* u = std::get_if<Union>(&shape.expression))
      return simplify(u->operands, true, next, values);
    if (const auto* i = std::get_if<Intersection>(&shape.expression))
      return simplify(i->operands, false, next, values);
    if (const auto* c = std::get_if<Covered>(&shape.expression)) return simplify(*c->over, next, values);
    if (const auto* p = std::get_if<Painted>(&shape.expression)) return simplify(*p->over, next, values);
    return {false, {}};
  }
  static Simplified simplify(const std::vector<Shape>& operands, bool absorbing, Leaf& next,
                             const LeafValues& values) {
    Simplified all{!absorbing, {}};
    bool is_absorbed = false;
    for (const Shape& operand : operands) {
      const Simplified one = simplify(operand, next, values);
      is_absorbed |= one.standing.empty() && one.value == absorbing;
      all.standing.insert(one.standing.begin(), one.standing.end());
    }
    return is_absorbed ? Simplified{absorbing, {}} : all;
  }
  Simplified simplify(const LeafValues& values) const {
    Leaf next = 0;
    return simplify(shape_, next, values);
  }

  static LeafValue constant(bool value) { return value ? LeafValue::yes : LeafValue::no; }
  bool is_member(const Shape& shape, const Fraction& lambda) const {
    std::vector<HalfSpace> leaves;
    collect(shape, leaves);
    Leaf next = 0;
    return simplify(shape, next, [&](Leaf i) { return constant(sign_at(leaves[i], lambda) <= 0); }).value;
  }

  void collect(const Shape& shape) { collect(shape, leaves_); }
  static void collect(const Shape& shape, std::vector<HalfSpace>& leaves) {
    if (const auto* h = std::get_if<HalfSpace>(&shape.expression)) leaves.push_back(*h);
    if (const auto* u = std::get_if<Union>(&shape.expression))
      for (const Shape& operand : u->operands) collect(operand, leaves);
    if (const auto* i = std::get_if<Intersection>(&shape.expression))
      for (const Shape& operand : i->operands) collect(operand, leaves);
    if (const auto* c = std::get_if<Covered>(&shape.expression)) collect(*c->over, leaves);
    if (const auto* p = std::get_if<Painted>(&shape.expression)) collect(*p->over, leaves);
  }

  Direction normal(Leaf i) const { return integers(leaves_[i].normal); }
  bool is_on(Leaf i) const { return normal(i) != Direction{} && sign_at(leaves_[i], lambda_) == 0; }
  bool is_entered(Leaf i) const { return delta(leaves_[i], to_) < delta(leaves_[i], from_); }
  bool away_from_planes(const Direction& v, const std::function<bool(Leaf)>& considered) const {
    for (Leaf j = 0; j < leaves_.size(); ++j)
      if (is_on(j) && considered(j) && dot(normal(j), v) == 0) return false;
    return true;
  }
  // Is v, turned by an infinitesimal amount towards `turned`, in the local cone?
  bool in_cone(const Direction& v, const Direction& turned) const {
    return simplify([&](Leaf j) {
             if (!is_on(j)) return constant(sign_at(leaves_[j], lambda_) <= 0);
             const Integer along = dot(normal(j), v);
             return constant((along != 0 ? along : dot(normal(j), turned)) <= 0);
           })
        .value;
  }
  static bool some_direction(const std::function<bool(const Direction&)>& predicate) {
    for (Integer x = -6; x <= 6; ++x)
      for (Integer y = -6; y <= 6; ++y)
        for (Integer z = -6; z <= 6; ++z)
          if (predicate({x, y, z})) return true;
    return false;
  }
  bool is_interior() const {
    return !some_direction([&](const Direction& v) {
      return away_from_planes(v, [](Leaf) { return true; }) && !in_cone(v, Direction{});
    });
  }
  bool bounds(Leaf i) const {
    const auto has_other_plane = [&](Leaf j) { return !are_parallel(normal(i), normal(j)); };
    return some_direction([&](const Direction& v) {
      if (dot(normal(i), v) != 0 || !away_from_planes(v, has_other_plane)) return false;
      if (!in_cone(v, Direction{}) || in_cone(v, normal(i))) return false;
      const auto value_at_v = [&](Leaf j) {
        if (!is_on(j)) return constant(sign_at(leaves_[j], lambda_) <= 0);
        return has_other_plane(j) ? constant(dot(normal(j), v) <= 0) : LeafValue::kept;
      };
      return simplify(value_at_v).standing.count(i) > 0;
    });
  }

  EntryAnswer at_lambda(bool is_at_start) const {
    if (is_at_start && is_interior()) return Inside{lambda_.value()};
    for (Leaf i = 0; i < leaves_.size(); ++i)
      if (is_on(i) && (is_at_start || is_entered(i)) && bounds(i)) return border(i);
    const auto standing = simplify([&](Leaf j) {
                            return is_on(j) ? LeafValue::kept : constant(sign_at(leaves_[j], lambda_) <= 0);
                          }).standing;
    for (const Leaf i : standing)
      if (is_at_start || is_entered(i)) return border(i);
    return Miss{};  // cannot be
  }

  Border border(Leaf i) const {
    Leaf next = 0;
    std::optional<MaterialIndex> material;
    walk(shape_, i, next, material);
    return {lambda_.value(), i, leaves_[i].normal, material};
  }
  // Is leaf `wanted` in the shape? If so, `material` becomes what its outermost cover or paint says.
  bool walk(const Shape& shape, Leaf wanted, Leaf& next, std::optional<MaterialIndex>& material) const {
    if (std::holds_alternative<HalfSpace>(shape.expression)) return next++ == wanted;
    const auto walk_all = [&](const std::vector<Shape>& operands) {
      bool found = false;
      for (const Shape& operand : operands) found |= walk(operand, wanted, next, material);
      return found;
    };
    if (const auto* u = std::get_if<Union>(&shape.expression)) return walk_all(u->operands);
    if (const auto* i = std::get_if<Intersection>(&shape.expression)) return walk_all(i->operands);
    if (const auto* c = std::get_if<Covered>(&shape.expression)) {
      const bool found = walk(*c->over, wanted, next, material);
      if (found) material = c->material;
      return found;
    }
    if (const auto* p = std::get_if<Painted>(&shape.expression)) {
      const bool found = walk(*p->over, wanted, next, material);
      if (found && is_member(*p->where, lambda_)) material = p->material;
      return found;
    }
    return false;
  }

  const Shape& shape_;
  const EntryAsk& ask_;
  const Direction from_;
  const Direction to_;
  std::vector<HalfSpace> leaves_;
  Fraction lambda_;
};

}  // namespace groundtruth::lattice
