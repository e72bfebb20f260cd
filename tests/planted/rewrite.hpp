#pragma once
// Other expressions with as many leaves.

#include <functional>

#include <groundtruth/problem/scene.hpp>

namespace groundtruth::planted {

// Changes each expression of the solid, operands first; `depth` is how many unions and intersections stand
// around it. Regions of paint stay as they are.
using Change = std::function<Shape(Shape, unsigned depth)>;
Shape rewritten(const Shape& shape, const Change& change, unsigned depth = 0);

// The same, of each half-space of the solid.
Scene with_half_spaces(Scene scene, HalfSpace (*change)(HalfSpace));

// Nothing, everything: with the leaves of the shape, which then count for nothing.
Shape as_nothing(Shape shape);
Shape as_everything(Shape shape);

}  // namespace groundtruth::planted
