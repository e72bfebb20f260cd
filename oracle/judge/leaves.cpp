#include "leaves.hpp"

#include <algorithm>
#include <memory>

namespace groundtruth::judge {
namespace {

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

void append_leaves(const Shape& shape, std::vector<HalfSpace>& leaves) {
  const auto each = [&](const std::vector<Shape>& operands) {
    for (const Shape& operand : operands) append_leaves(operand, leaves);
  };
  std::visit(Overloaded{[&](const HalfSpace& leaf) { leaves.push_back(leaf); },
                        [&](const Union& of) { each(of.operands); },
                        [&](const Intersection& of) { each(of.operands); },
                        [&](const Covered& of) { append_leaves(*of.over, leaves); },
                        [&](const Painted& of) { append_leaves(*of.over, leaves); }, [](const auto&) {}},
             shape.expression);
}

// Whether the shape contains the point when each plane is moved outwards by `shift` metres; inwards if
// negative.
bool contains(const Shape& shape, const RationalVector& point, double shift) {
  const auto in = [&](const Shape& part) { return contains(part, point, shift); };
  return std::visit(
      Overloaded{
          [](const Everything&) { return true; }, [](const Nothing&) { return false; },
          [&](const HalfSpace& half_space) {
            const RationalVector normal = rational(half_space.normal);
            const Rational height = dot(normal, point) - rational(half_space.offset);
            const Rational moved = rational(shift) * rational(shift) * dot(normal, normal);
            if (shift >= 0) return height <= 0 || height * height <= moved;
            return height <= 0 && height * height >= moved;
          },
          [&](const Union& of) { return std::any_of(of.operands.begin(), of.operands.end(), in); },
          [&](const Intersection& of) { return std::all_of(of.operands.begin(), of.operands.end(), in); },
          [&](const Covered& of) { return in(*of.over); }, [&](const Painted& of) { return in(*of.over); }},
      shape.expression);
}

class Materials {
 public:
  explicit Materials(const Around& around) : around_(around) {}

  void walk(const Shape& shape, Leaf leaf) {
    std::visit(Overloaded{[&](const HalfSpace&) { found_.insert(std::nullopt); },
                          [&](const Union& of) { enter(of.operands, leaf); },
                          [&](const Intersection& of) { enter(of.operands, leaf); },
                          [&](const Covered& of) { found_.insert(of.material); },
                          [&](const Painted& of) { paint(of, leaf); }, [](const auto&) {}},
               shape.expression);
  }
  std::set<MaterialOrNone> found() && { return std::move(found_); }

 private:
  void enter(const std::vector<Shape>& operands, Leaf leaf) {
    for (const Shape& operand : operands) {
      const std::size_t leaves = leaf_count(operand);
      if (leaf < leaves) return walk(operand, leaf);
      leaf -= leaves;
    }
  }
  void paint(const Painted& of, Leaf leaf) {
    if (contains(*of.where, around_.point_in_world, around_.radius)) found_.insert(of.material);
    if (!contains(*of.where, around_.point_in_world, -around_.radius)) walk(*of.over, leaf);
  }

  const Around& around_;
  std::set<MaterialOrNone> found_;
};

// Puts the operand that holds the leaf first, itself reordered.
void put_first(std::vector<Shape>& operands, Leaf leaf) {
  for (auto operand = operands.begin(); operand != operands.end(); ++operand) {
    const std::size_t leaves = leaf_count(*operand);
    if (leaf < leaves) {
      *operand = with_leaf_first(*operand, leaf);
      std::rotate(operands.begin(), operand, operand + 1);
      return;
    }
    leaf -= leaves;
  }
}

}  // namespace

std::size_t leaf_count(const Shape& shape) {
  const auto of_all = [](const std::vector<Shape>& operands) {
    std::size_t all = 0;
    for (const Shape& operand : operands) all += leaf_count(operand);
    return all;
  };
  return std::visit(Overloaded{[](const HalfSpace&) -> std::size_t { return 1; },
                               [&](const Union& of) { return of_all(of.operands); },
                               [&](const Intersection& of) { return of_all(of.operands); },
                               [](const Covered& of) { return leaf_count(*of.over); },
                               [](const Painted& of) { return leaf_count(*of.over); },
                               [](const auto&) -> std::size_t { return 0; }},
                    shape.expression);
}

std::vector<HalfSpace> leaves_of(const Shape& shape) {
  std::vector<HalfSpace> leaves;
  append_leaves(shape, leaves);
  return leaves;
}

std::set<MaterialOrNone> materials_of(const Shape& shape, Leaf leaf, const Around& around) {
  Materials materials(around);
  materials.walk(shape, leaf);
  return std::move(materials).found();
}

Shape with_leaf_first(const Shape& shape, Leaf leaf) {
  Shape result = shape;
  std::visit(
      Overloaded{
          [&](Union& of) { put_first(of.operands, leaf); },
          [&](Intersection& of) { put_first(of.operands, leaf); },
          [&](Covered& of) { of.over = std::make_shared<const Shape>(with_leaf_first(*of.over, leaf)); },
          [&](Painted& of) { of.over = std::make_shared<const Shape>(with_leaf_first(*of.over, leaf)); },
          [](const auto&) {}},
      result.expression);
  return result;
}

}  // namespace groundtruth::judge
