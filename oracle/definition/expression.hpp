#pragma once
// A solid written out as a list of nodes, with half-spaces in integers, and membership by its definition
// (SPEC section 2).

#include <optional>
#include <vector>

#include <groundtruth/definition/real.hpp>
#include <groundtruth/problem/shape.hpp>

namespace groundtruth::definition {

// A half-space whose four numbers were multiplied by one positive number.
struct WholeHalfSpace {
  Triple<Integer> normal;
  Integer offset;
  Vector normal_as_written{};
};

struct Node {
  enum class Kind { nothing, everything, leaf, any_operand, every_operand };
  Kind kind = Kind::nothing;
  std::size_t parent = 0;    // the root is its own
  std::size_t operands = 0;  // how many
  Leaf leaf = 0;             // if kind is leaf
  // What `Covered` and `Painted` say; such a node has one operand.
  std::optional<MaterialIndex> material;
  std::optional<std::size_t> region;  // in Expression::regions; absent: everywhere
};

struct Expression {
  std::vector<Node> nodes;                  // the root first, each after its parent
  std::vector<WholeHalfSpace> half_spaces;  // by leaf
  std::vector<std::size_t> node_of_leaf;
  std::vector<Expression> regions;
};

Expression expression_of(const Shape& shape);

// The point numerators / weight, weight > 0.
struct Point {
  Triple<Whole> numerators;
  Integer weight;
};

// By leaf: a positive multiple of Delta(point).
using Heights = std::vector<Whole>;
Heights heights(const Expression& expression, const Point& point);

// By leaf: the sign of Delta(point), but of a half-space with normal 0, which has no boundary: -1 if it is
// everything, 1 if it is nothing.
using Sides = std::vector<signed char>;
Sides sides(const Expression& expression, const Heights& heights);

// Whether a half-space holds the points of its plane. SPEC's do; the other reading is its interior.
enum class Reading { closed, open };
constexpr bool holds(signed char side, Reading reading) {
  return reading == Reading::closed ? side <= 0 : side < 0;
}

// By node: is the point with these sides a member of it?
std::vector<bool> membership(const Expression& expression, const Sides& sides, Reading reading);
bool is_member(const Expression& expression, const Point& point);

}  // namespace groundtruth::definition
