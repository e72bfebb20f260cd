#include "moved_planes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "number.hpp"

namespace groundtruth::judge {
namespace {

// Whether `offset` lies at least |metres| ||n|| beyond the leaf's own, on the side that `metres` says.
bool is_far_enough(double offset, const HalfSpace& leaf, double metres) {
  const RationalVector normal = rational(leaf.normal);
  const Rational moved = rational(offset) - rational(leaf.offset);
  const bool right_side = metres > 0 ? moved >= 0 : moved <= 0;
  return right_side && moved * moved >= rational(metres) * rational(metres) * dot(normal, normal);
}

// The same half-space with a normal about as long as 1, as an ulp of a tiny offset may be metres.
HalfSpace without_tiny_numbers(const HalfSpace& leaf) {
  const Vector& n = leaf.normal;
  const double longest = std::max({std::fabs(n[0]), std::fabs(n[1]), std::fabs(n[2])});
  if (longest > 0x1p-900) return leaf;
  const int power = -std::ilogb(longest);
  const auto larger = [&](double number) { return std::scalbn(number, power); };
  const HalfSpace scaled{{larger(n[0]), larger(n[1]), larger(n[2])}, larger(leaf.offset)};
  return std::isfinite(scaled.offset) ? scaled : leaf;
}

Shape moved(const HalfSpace& given, double metres) {
  if (given.normal == Vector{}) return {given};
  const HalfSpace leaf = without_tiny_numbers(given);
  const double outwards = std::copysign(std::numeric_limits<double>::infinity(), metres);
  double offset = leaf.offset + metres * std::hypot(leaf.normal[0], leaf.normal[1], leaf.normal[2]);
  while (std::isfinite(offset) && !is_far_enough(offset, leaf, metres))
    offset = std::nextafter(offset, outwards);
  if (std::isfinite(offset)) return {HalfSpace{leaf.normal, offset}};
  return metres > 0 ? Shape{Everything{}} : Shape{Nothing{}};
}

class Move {
 public:
  explicit Move(double metres) : metres_(metres) {}

  Shape operator()(const HalfSpace& leaf) const { return moved(leaf, metres_); }
  Shape operator()(const Union& of) const { return {Union{each(of.operands)}}; }
  Shape operator()(const Intersection& of) const { return {Intersection{each(of.operands)}}; }
  Shape operator()(const Covered& of) const { return {Covered{of.material, over(of.over)}}; }
  Shape operator()(const Painted& of) const { return {Painted{of.material, of.where, over(of.over)}}; }
  template <typename Constant>
  Shape operator()(const Constant& constant) const {
    return {constant};
  }

 private:
  std::vector<Shape> each(const std::vector<Shape>& operands) const {
    std::vector<Shape> all;
    all.reserve(operands.size());
    for (const Shape& operand : operands) all.push_back(with_planes_moved(operand, metres_));
    return all;
  }
  std::shared_ptr<const Shape> over(const std::shared_ptr<const Shape>& shape) const {
    return std::make_shared<const Shape>(with_planes_moved(*shape, metres_));
  }

  double metres_;
};

}  // namespace

Shape with_planes_moved(const Shape& shape, double metres) {
  return std::visit(Move(metres), shape.expression);
}

}  // namespace groundtruth::judge
