#pragma once
// Shapes of small whole numbers, in which nearly everything is degenerate.

#include <rapidcheck.h>

#include "shapes.hpp"

namespace groundtruth::definition::test {

// As likely all of them, whatever RapidCheck's size is.
inline int whole(int low, int high) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high + 1));
}
inline double small(int low, int high) { return whole(low, high); }
inline Vector small_vector(int low, int high) {
  return {small(low, high), small(low, high), small(low, high)};
}

inline Shape some_box() {
  const Vector low = small_vector(0, 2);
  return box(low, {low[0] + small(0, 2), low[1] + small(0, 2), low[2] + small(0, 2)});
}

inline Shape some_simple_shape(int steepest) {
  switch (whole(0, 11)) {
    case 0:
      return small(0, 1) == 0 ? Shape{Nothing{}} : Shape{Everything{}};
    case 1:
      return half_space(small(-steepest, steepest), small(-steepest, steepest), small(-steepest, steepest),
                        small(-3, 3));
    case 2:
    case 3: {
      const int axis = whole(0, 2);
      const double sign = small(0, 1) * 2 - 1;
      return half_space(axis == 0 ? sign : 0, axis == 1 ? sign : 0, axis == 2 ? sign : 0, sign * small(0, 3));
    }
    default:
      return some_box();
  }
}

// Of operations at most `depth` deep; the coordinates of normals reach from -steepest to steepest.
inline Shape some_shape(int depth, int steepest = 2) {
  if (depth == 0) return some_simple_shape(steepest);
  std::vector<Shape> operands;
  for (int count = whole(0, 9) == 0 ? 0 : whole(1, 5); count > 0; --count)
    operands.push_back(some_shape(whole(0, depth - 1), steepest));
  return whole(0, 3) > 0 ? any_of(std::move(operands)) : all_of(std::move(operands));
}

// Boxes that touch and overlap, and other things, mostly within [0, 4] on each axis.
inline Shape some_solid(int steepest = 2) {
  std::vector<Shape> operands;
  for (int count = whole(1, 4); count > 0; --count) {
    if (whole(0, 3) > 0)
      operands.push_back(some_box());
    else
      operands.push_back(all_of({some_shape(1, steepest), some_shape(1, steepest)}));
  }
  return any_of(std::move(operands));
}

// Outside of [0, 4] on one axis.
inline Vector some_start() {
  Vector start = small_vector(-2, 6);
  start[static_cast<std::size_t>(whole(0, 2))] = whole(0, 1) == 0 ? -2 : 6;
  return start;
}

}  // namespace groundtruth::definition::test
