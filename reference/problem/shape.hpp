#pragma once
// Solids as positive Boolean expressions of half-spaces (SPEC section 2).

#include <cstddef>
#include <memory>
#include <variant>
#include <vector>

#include <groundtruth/problem/vector.hpp>

namespace groundtruth {

// The solid {x : normal . x <= offset}, closed. `normal` points out of it and need not be of unit length;
// a zero normal is legal and means everything if offset >= 0, else nothing.
struct HalfSpace {
  Vector normal{};
  double offset = 0;
  bool operator==(const HalfSpace&) const = default;
};

struct Everything {};
struct Nothing {};

struct Shape;

// The union of no operands is nothing.
struct Union {
  std::vector<Shape> operands;
};

// The intersection of no operands is everything.
struct Intersection {
  std::vector<Shape> operands;
};

// A place in `Scene::materials`.
using MaterialIndex = std::size_t;

// Every face of `over` is made of `material`.
struct Covered {
  MaterialIndex material = 0;
  std::shared_ptr<const Shape> over;
};

// The faces of `over` are made of `material` at the points that lie in `where`. The half-spaces of `where`
// are only asked for membership: they are no leaves.
struct Painted {
  MaterialIndex material = 0;
  std::shared_ptr<const Shape> where;
  std::shared_ptr<const Shape> over;
};

// Leaves are the half-spaces of the solid in the order in which they stand, depth first, from 0; that is how
// answers name a face. Where several `Covered` and `Painted` apply to a leaf, the outermost decides.
struct Shape {
  std::variant<Everything, Nothing, HalfSpace, Union, Intersection, Covered, Painted> expression;
};

// A leaf's number, as defined above.
using Leaf = std::size_t;

}  // namespace groundtruth
