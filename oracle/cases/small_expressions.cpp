// Expressions that nest, repeat and degenerate.

#include <numeric>
#include <utility>

#include <groundtruth/cases/ground_materials.hpp>
#include <groundtruth/cases/shape_parts.hpp>
#include <groundtruth/cases/vector_arithmetic.hpp>

#include "small_shapes.hpp"

namespace groundtruth::cases {
namespace {

Shape simple_operand(Random& random) {
  if (random.one_in(12)) return {Everything{}};
  if (random.one_in(12)) return {Nothing{}};
  return random.one_in(4) ? lattice_box(random) : lattice_plane(random);
}

Shape decorated(Shape shape, Random& random) {
  if (random.one_in(3)) return of_some_material(std::move(shape), random);
  if (!random.one_in(4)) return shape;
  Shape where = some_region(random);
  return painted(random.below(4), std::move(where), std::move(shape));
}

// Levels alternate, so that flattening does not undo the depth.
Shape alternating(unsigned depth, bool meets, Random& random) {
  if (depth == 0) return decorated(random.one_in(4) ? lattice_box(random) : lattice_plane(random), random);
  std::vector<Shape> parts{alternating(depth - 1, !meets, random)};
  const std::uint64_t more = 1 + random.below(2);
  for (std::uint64_t i = 0; i < more; ++i) parts.push_back(decorated(simple_operand(random), random));
  if (random.one_in(2)) std::swap(parts.front(), parts.back());
  Shape shape = meets ? intersection_of(std::move(parts)) : union_of(std::move(parts));
  return decorated(std::move(shape), random);
}

}  // namespace

Shape nested_expression(Random& random) {
  const auto depth = static_cast<unsigned>(1 + random.below(6));
  const bool meets = random.one_in(2);
  return alternating(depth, meets, random);
}

Shape wide_expression(Random& random) {
  std::vector<Shape> parts;
  const std::uint64_t count = random.one_in(4) ? 9 + random.below(37) : 9 + random.below(8);
  const bool boxes = random.one_in(3);
  for (std::uint64_t i = 0; i < count; ++i) {
    parts.push_back(of_some_material(boxes && i < 6 ? lattice_box(random) : lattice_plane(random), random));
  }
  if (random.one_in(2)) return intersection_of(std::move(parts));
  // Planes joined fill space; cut to boxes they leave something to hit.
  for (Shape& part : parts) part = intersection_of({std::move(part), lattice_plane(random)});
  return union_of(std::move(parts));
}

Shape many_sided_prism(Random& random) {
  const std::size_t axis = random.below(3);
  const std::uint64_t most = random.one_in(2) ? 70 : 24;
  const double radius = random.dyadic(1, 3, 1);
  std::vector<Shape> sides;
  for (int a = -6; a <= 6; ++a) {
    for (int b = -6; b <= 6; ++b) {
      if (std::gcd(a, b) != 1) continue;
      Vector normal{};
      normal[(axis + 1) % 3] = a;
      normal[(axis + 2) % 3] = b;
      const double offset = radius * length(normal);
      sides.push_back(of_some_material(half_space(normal[0], normal[1], normal[2], offset), random));
    }
  }
  while (sides.size() > most) {
    std::swap(sides[random.below(sides.size())], sides.back());
    sides.pop_back();
  }
  return intersection_of(std::move(sides));
}

Shape notched_box(Random& random) {
  std::vector<Shape> parts{lattice_box(random)};
  const std::uint64_t notches = 1 + random.below(2);
  for (std::uint64_t i = 0; i < notches; ++i) {
    parts.push_back(of_some_material(union_of({lattice_plane(random), lattice_plane(random)}), random));
  }
  return of_some_material(intersection_of(std::move(parts)), random);
}

Shape repeated_shape(Random& random) {
  const Shape once = random.one_in(2) ? lattice_box(random) : wedge(random);
  std::vector<Shape> parts{of_some_material(once, random), of_some_material(once, random)};
  if (random.one_in(2)) parts.push_back(of_some_material(intersection_of({once, once}), random));
  if (random.one_in(2)) parts.push_back(lattice_plane(random));
  return random.one_in(4) ? intersection_of(std::move(parts)) : union_of(std::move(parts));
}

Shape interleaved_unions(Random& random) {
  const std::size_t axis = random.below(3);
  std::vector<Shape> combs;
  for (int comb = 0; comb < 2; ++comb) {
    std::vector<Shape> teeth;
    double at = random.dyadic(-4, -1, 1);
    const std::uint64_t count = 3 + random.below(3);
    for (std::uint64_t i = 0; i < count; ++i) {
      Vector low{-2, -2, -2}, high{2, 2, 2};
      low[axis] = at;
      at += random.dyadic(0, 2, 1);
      high[axis] = at;
      at += random.dyadic(0, 2, 1) + 0.5;
      teeth.push_back(of_some_material(box(low, high), random));
    }
    combs.push_back(union_of(std::move(teeth)));
  }
  return intersection_of(std::move(combs));
}

Shape odd_operands(Random& random) {
  std::vector<Shape> parts{of_some_material(lattice_box(random), random)};
  const std::uint64_t count = 1 + random.below(3);
  const bool meets = random.one_in(2);
  for (std::uint64_t i = 0; i < count; ++i) {
    switch (random.below(6)) {
      case 0:
        parts.push_back(half_space(0, 0, 0, meets ? random.dyadic(0, 1, 0) : -1));
        break;
      case 1:
        parts.push_back(half_space(0, 0, 0, random.dyadic(-1, 1, 0)));
        break;
      case 2:
        parts.push_back(meets ? intersection_of({}) : union_of({}));
        break;
      case 3:
        parts.push_back(meets ? Shape{Everything{}} : Shape{Nothing{}});
        break;
      default:
        parts.push_back(lattice_plane(random));
    }
  }
  if (random.one_in(2)) std::swap(parts.front(), parts.back());
  return meets ? intersection_of(std::move(parts)) : union_of(std::move(parts));
}

}  // namespace groundtruth::cases
