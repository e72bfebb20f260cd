// Solids that touch: what seams and abutting faces are made of.

#include <cmath>
#include <utility>

#include <groundtruth/cases/ground_materials.hpp>
#include <groundtruth/cases/shape_parts.hpp>

#include "small_shapes.hpp"

namespace groundtruth::cases {
namespace {

double or_next_to_it(double value, Random& random) {
  return random.one_in(12) ? one_ulp_off(value, random) : value;
}

}  // namespace

Shape of_some_material(Shape shape, Random& random) {
  const std::uint64_t kind = random.below(16);
  if (kind == 0) return shape;
  constexpr MaterialIndex common[] = {dry, wet, icy, dirty};
  if (kind == 1) return covered(random.one_in(2) ? water : glass, std::move(shape));
  return covered(random.pick(common), std::move(shape));
}

Shape seam_row(Random& random) {
  const double size = std::ldexp(1.0, static_cast<int>(random.between(-1, 2)));
  const double top = random.dyadic(-1, 2, 1);
  std::vector<Shape> boxes;
  double begin = random.dyadic(-3, 1, 1);
  const std::uint64_t count = 2 + random.below(3);
  for (std::uint64_t i = 0; i < count; ++i) {
    const double end = begin + size;
    const double high = random.one_in(6) ? top + random.dyadic(-1, 1, 2) : or_next_to_it(top, random);
    boxes.push_back(of_some_material(box({begin, -2, top - 2}, {end, 2, high}), random));
    begin = or_next_to_it(end, random);
  }
  return union_of(std::move(boxes));
}

Shape slab_stack(Random& random) {
  const bool endless = random.one_in(2);
  double bottom = -2;
  std::vector<Shape> slabs;
  const std::uint64_t count = 2 + random.below(3);
  for (std::uint64_t i = 0; i < count; ++i) {
    const double top = bottom + random.dyadic(0, 2, 1);
    Shape slab = endless ? intersection_of({half_space(0, 0, 1, top), half_space(0, 0, -1, 0 - bottom)})
                         : box({-2, -2, bottom}, {2, 2, top});
    slabs.push_back(of_some_material(std::move(slab), random));
    bottom = or_next_to_it(top, random);
  }
  return union_of(std::move(slabs));
}

// Of the eight unit boxes around a lattice point, some.
Shape tiled_corner(Random& random) {
  const Vector corner{random.dyadic(-1, 1, 0), random.dyadic(-1, 1, 0), random.dyadic(-1, 1, 0)};
  const std::uint64_t present = random.below(256);
  std::vector<Shape> boxes;
  for (unsigned octant = 0; octant < 8; ++octant) {
    if ((present >> octant & 1U) == 0) continue;
    Vector low = corner;
    for (unsigned axis = 0; axis < 3; ++axis) low[axis] -= (octant >> axis & 1U) != 0 ? 0 : 1;
    boxes.push_back(of_some_material(box(low, {low[0] + 1, low[1] + 1, low[2] + 1}), random));
  }
  return union_of(std::move(boxes));
}

Shape ground_with_things(Random& random) {
  std::vector<Shape> parts{of_some_material(half_space(0, 0, 1, random.dyadic(-1, 1, 1)), random)};
  const std::uint64_t count = 1 + random.below(3);
  for (std::uint64_t i = 0; i < count; ++i) {
    parts.push_back(of_some_material(random.one_in(3) ? wedge(random) : lattice_box(random), random));
  }
  if (random.one_in(2)) std::swap(parts.front(), parts.back());
  return union_of(std::move(parts));
}

}  // namespace groundtruth::cases
