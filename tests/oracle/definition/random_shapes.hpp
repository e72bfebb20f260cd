#pragma once
// Shapes of small whole numbers, in which nearly everything is degenerate.

#include <rapidcheck.h>

#include "shapes.hpp"

namespace groundtruth::definition::test {

inline double small(int low, int high) { return *rc::gen::inRange(low, high + 1); }
inline Vector small_vector(int low, int high) { return {small(low, high), small(low, high), small(low, high)}; }

// The coordinates of normals reach from -steepest to steepest.
inline Shape some_shape(int depth, int steepest = 2) {
  const int kind = depth == 0 ? *rc::gen::inRange(0, 5) : *rc::gen::inRange(0, 12);
  if (kind == 0 || kind == 1) {
    const Vector low = small_vector(0, 2);
    return box(low, {low[0] + small(0, 2), low[1] + small(0, 2), low[2] + small(0, 2)});
  }
  if (kind == 2) return half_space(small(-steepest, steepest), small(-steepest, steepest), small(-steepest, steepest), small(-3, 3));
  if (kind < 5) {
    const double sign = small(0, 1) * 2 - 1;
    const int axis = *rc::gen::inRange(0, 3);
    return half_space(axis == 0 ? sign : 0, axis == 1 ? sign : 0, axis == 2 ? sign : 0, sign * small(0, 3));
  }
  if (kind == 5) return small(0, 1) == 0 ? Shape{Nothing{}} : Shape{Everything{}};
  std::vector<Shape> operands;
  for (int count = *rc::gen::inRange(0, 5); count > 0; --count) operands.push_back(some_shape(depth - 1, steepest));
  return kind < 10 ? any_of(std::move(operands)) : all_of(std::move(operands));
}

}  // namespace groundtruth::definition::test
