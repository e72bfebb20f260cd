#pragma once
// Short spellings for shapes written in code.

#include <cstddef>
#include <functional>
#include <vector>

#include <groundtruth/problem/shape.hpp>

namespace groundtruth::cases {

Shape half_space(double nx, double ny, double nz, double offset);

// [low, high], as the faces -x, +x, -y, +y, -z, +z in this order (SPEC section 8).
Shape box(const Vector& low, const Vector& high);

Shape union_of(std::vector<Shape> operands);
Shape intersection_of(std::vector<Shape> operands);
Shape covered(MaterialIndex material, Shape over);
Shape painted(MaterialIndex material, Shape where, Shape over);

// The shape with every half-space replaced, leaf or not, in the order in which they stand.
Shape with_each_plane(const Shape& shape, const std::function<HalfSpace(const HalfSpace&)>& replacement);

// How many leaves the shape has; regions of paint have none.
std::size_t leaf_count(const Shape& shape);

}  // namespace groundtruth::cases
