#pragma once
// A scene whose planes are numbers of some arithmetic.

#include <cstddef>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include <groundtruth/problem/scene.hpp>
#include <groundtruth/tiers/naive/arithmetic.hpp>
#include <groundtruth/tiers/naive/vector3.hpp>

namespace groundtruth::tiers::naive {

enum class Operation { everything, nothing, half_space, union_of, intersection_of };

// Operands follow their operator, depth first: the first stands right behind it, the next at the end of the
// one before.
template <class Real>
struct Node {
  Operation operation = Operation::nothing;
  std::size_t end = 0;  // one past the last node below
  Leaf leaf = 0;        // of a half-space, as are these
  HalfSpace written;
  Vector3<Real> normal;
  Real offset{};
};

template <class Real>
using Solid = std::vector<Node<Real>>;

// n . x - d
template <class Real>
Real distance(const Node<Real>& plane, const Vector3<Real>& point) {
  return dot(plane.normal, point) - plane.offset;
}

template <class Real>
bool contains(const Solid<Real>& solid, std::size_t node, const Vector3<Real>& point) {
  const Node<Real>& here = solid[node];
  if (here.operation == Operation::half_space) return sign_of(distance(here, point)) <= 0;
  if (here.operation == Operation::everything) return true;
  const bool decides = here.operation == Operation::union_of;
  for (std::size_t operand = node + 1; operand < here.end; operand = solid[operand].end)
    if (contains(solid, operand, point) == decides) return decides;
  return here.operation == Operation::intersection_of;
}

// `material` where `region` is; everywhere, if absent.
template <class Real>
struct Paint {
  MaterialIndex material = 0;
  std::optional<Solid<Real>> region;
  std::optional<std::size_t> outer;  // the next one on the way to the root, a place in Ground::paints
};

template <class Real>
struct Ground {
  Solid<Real> solid;
  std::vector<Paint<Real>> paints;
  std::vector<std::optional<std::size_t>> innermost_paint;  // by leaf
  std::vector<Material> materials;

  // The outermost paint that reaches the point decides.
  std::optional<MaterialIndex> material_at(Leaf leaf, const Vector3<Real>& point) const {
    std::optional<MaterialIndex> material;
    for (auto paint = innermost_paint[leaf]; paint; paint = paints[*paint].outer) {
      const auto& region = paints[*paint].region;
      if (!region || contains(*region, 0, point)) material = paints[*paint].material;
    }
    return material;
  }
};

// Lays a shape out in a ground.
template <class Real>
class Layer {
 public:
  explicit Layer(Ground<Real>& ground) : ground_(ground) {}

  void lay(const Shape& shape) {
    std::visit([this](const auto& expression) { this->lay(expression); }, shape.expression);
  }

 private:
  void lay(const Everything&) { add(Operation::everything); }
  void lay(const Nothing&) { add(Operation::nothing); }
  void lay(const Union& shape) { lay_operands(Operation::union_of, shape.operands); }
  void lay(const Intersection& shape) { lay_operands(Operation::intersection_of, shape.operands); }
  void lay(const Covered& shape) { lay_under({shape.material, {}, innermost_}, *shape.over); }
  void lay(const Painted& shape) {
    Ground<Real> region;
    Layer(region).lay(*shape.where);
    lay_under({shape.material, std::move(region.solid), innermost_}, *shape.over);
  }
  void lay(const HalfSpace& half_space) {
    const Leaf leaf = ground_.innermost_paint.size();
    ground_.innermost_paint.push_back(innermost_);
    if (half_space.normal == Vector{0, 0, 0}) {
      add(half_space.offset >= 0 ? Operation::everything : Operation::nothing);
      return;
    }
    Node<Real>& node = add(Operation::half_space);
    node.leaf = leaf;
    node.written = half_space;
    node.normal = as<Real>(half_space.normal);
    node.offset = Real(half_space.offset);
  }

  Node<Real>& add(Operation operation) {
    Node<Real>& node = ground_.solid.emplace_back();
    node.operation = operation;
    node.end = ground_.solid.size();
    return node;
  }

  void lay_operands(Operation operation, const std::vector<Shape>& operands) {
    const std::size_t place = ground_.solid.size();
    add(operation);
    for (const Shape& operand : operands) lay(operand);
    ground_.solid[place].end = ground_.solid.size();
  }

  void lay_under(Paint<Real> paint, const Shape& over) {
    const auto outer = innermost_;
    innermost_ = ground_.paints.size();
    ground_.paints.push_back(std::move(paint));
    lay(over);
    innermost_ = outer;
  }

  Ground<Real>& ground_;
  std::optional<std::size_t> innermost_;
};

template <class Real>
Ground<Real> ground_of(const Scene& scene) {
  Ground<Real> ground;
  Layer<Real>(ground).lay(scene.shape);
  ground.materials = scene.materials;
  return ground;
}

}  // namespace groundtruth::tiers::naive
