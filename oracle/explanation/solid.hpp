#pragma once
// A solid's expression as a tree that can be lit: every part true or false at a point.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <groundtruth/explanation/number.hpp>
#include <groundtruth/problem/scene.hpp>

namespace groundtruth::explanation {

// A leaf with its numbers as rationals, so that its offset can be moved exactly.
struct Plane {
  Leaf leaf = 0;  // its number in the whole scene
  RationalVector normal;
  Rational offset;
  Vector normal_as_written{};

  Rational height(const RationalVector& point) const { return dot(normal, point) - offset; }  // Delta
  bool is_a_plane() const { return normal != RationalVector{}; }
};

enum class Part { everything, nothing, leaf, united, intersected, covered, painted };

// In preorder: the operands of nodes[i] start at i + 1; each next one at the `end` of the one before.
struct Node {
  Part part = Part::nothing;
  std::size_t end = 0;
  std::size_t plane = 0;               // of a leaf: its place among the planes
  MaterialIndex material = 0;          // of what is covered or painted
  std::shared_ptr<const Shape> where;  // of what is painted
};

struct Solid {
  std::vector<Node> nodes;
  std::vector<Plane> planes;
};

enum class Truth { no, unknown, yes };
using TruthOfPlane = std::function<Truth(const Plane&)>;

std::vector<Plane> planes_of(const Shape& shape);

// The solid with the leaves that are known replaced by their values and constants simplified away (SPEC
// section 3). A single constant node if nothing else is left. What is covered stays covered.
Solid solid_where(const Shape& shape, const TruthOfPlane& truth);

// By node; `truth` says of each plane, by place, whether its half-space holds the point.
std::vector<bool> lit(const Solid& solid, const std::vector<bool>& truth);

// Of the whole solid, where some planes may be unknown.
Truth evaluate(const Solid& solid, const std::function<Truth(std::size_t)>& truth);

// The places of the planes that still stand when those known are replaced.
std::vector<bool> standing(const Solid& solid, const std::function<Truth(std::size_t)>& truth);

// Whether the shape contains the point.
bool contains(const Shape& shape, const RationalVector& point);

// Of the leaf at a point of its face: SPEC section 2.
std::optional<MaterialIndex> material_at(const Solid& solid, std::size_t plane, const RationalVector& point);

}  // namespace groundtruth::explanation
