// Planes that meet in edges and corners, and solids thinner than a face.

#include <algorithm>
#include <cmath>
#include <utility>

#include <groundtruth/cases/shape_parts.hpp>
#include <groundtruth/cases/vector_arithmetic.hpp>

#include "small_shapes.hpp"

namespace groundtruth::cases {
namespace {

Vector lattice_normal(Random& random) {
  Vector normal{};
  while (normal == Vector{}) {
    normal = {random.dyadic(-2, 2, 0), random.dyadic(-2, 2, 0), random.dyadic(-2, 2, 0)};
  }
  return normal;
}

// Often upright enough for a wheel to stand on.
Vector upward_normal(Random& random) {
  return {random.dyadic(-1, 1, 1), random.dyadic(-1, 1, 1), random.dyadic(1, 2, 1)};
}

Shape plane_through(const Vector& normal, const Vector& point) {
  return half_space(normal[0], normal[1], normal[2], dot(normal, point));
}

Vector lattice_point(Random& random) {
  return {random.dyadic(-2, 2, 1), random.dyadic(-2, 2, 1), random.dyadic(-2, 2, 1)};
}

Shape met_or_joined(std::vector<Shape> parts, Random& random) {
  return random.one_in(2) ? intersection_of(std::move(parts)) : union_of(std::move(parts));
}

}  // namespace

Shape lattice_plane(Random& random) {
  const Vector normal = lattice_normal(random);
  return plane_through(normal, lattice_point(random));
}

Shape lattice_box(Random& random) {
  const Vector low{random.dyadic(-2, 1, 0), random.dyadic(-2, 1, 0), random.dyadic(-2, 1, 0)};
  const auto size = [&] { return random.one_in(8) ? 0.0 : random.dyadic(1, 3, 0); };
  const Vector sizes{size(), size(), size()};
  return box(low, plus(low, sizes));
}

Shape wedge(Random& random) {
  const Vector point = lattice_point(random);
  const auto axis = static_cast<std::size_t>(random.below(2));  // the edge runs along x or y
  std::vector<Shape> planes;
  const std::uint64_t count = 2 + random.below(3);
  for (std::uint64_t i = 0; i < count; ++i) {
    Vector normal = random.one_in(3) ? lattice_normal(random) : upward_normal(random);
    normal[axis] = 0;
    planes.push_back(of_some_material(plane_through(normal, point), random));
  }
  return met_or_joined(std::move(planes), random);
}

Shape parallel_planes(Random& random) {
  const Vector normal = random.one_in(2) ? lattice_normal(random) : upward_normal(random);
  constexpr double lengths[] = {0.5, 1, 1, 2, 3, 5};
  std::vector<Shape> planes;
  const std::uint64_t count = 2 + random.below(3);
  for (std::uint64_t i = 0; i < count; ++i) {
    const double side = random.one_in(4) ? -1 : 1;
    const Vector scaled = times(side * random.pick(lengths), normal);
    const double offset = random.dyadic(-3, 5, 1);
    planes.push_back(of_some_material(half_space(scaled[0], scaled[1], scaled[2], offset), random));
  }
  if (random.one_in(2)) planes.push_back(of_some_material(lattice_plane(random), random));
  return met_or_joined(std::move(planes), random);
}

Shape spike(Random& random) {
  const Vector apex = lattice_point(random);
  std::vector<Shape> planes;
  const std::uint64_t count = 3 + random.below(5);
  for (std::uint64_t i = 0; i < count; ++i) {
    const Vector normal = random.one_in(2) ? lattice_normal(random) : upward_normal(random);
    planes.push_back(of_some_material(plane_through(normal, apex), random));
  }
  if (random.one_in(3)) return met_or_joined(std::move(planes), random);
  const auto middle = planes.begin() + static_cast<std::ptrdiff_t>(1 + random.below(count - 1));
  std::vector<Shape> first(planes.begin(), middle);
  std::vector<Shape> second(middle, planes.end());
  return random.one_in(2) ? union_of({intersection_of(std::move(first)), intersection_of(std::move(second))})
                          : intersection_of({union_of(std::move(first)), union_of(std::move(second))});
}

Shape thin_sheets(Random& random) {
  std::vector<Shape> sheets;
  const std::uint64_t count = 1 + random.below(3);
  for (std::uint64_t i = 0; i < count; ++i) {
    const Vector low{random.dyadic(-2, 0, 0), random.dyadic(-2, 0, 0), random.dyadic(-1, 1, 0)};
    Vector high = plus(low, {2, 2, 2});
    const std::uint64_t thin = 1 + random.below(random.one_in(4) ? 7 : 4);  // as bits: mostly one direction
    for (unsigned axis = 0; axis < 3; ++axis) {
      if ((thin >> (2 - axis) & 1U) != 0) high[axis] = low[axis];
    }
    sheets.push_back(of_some_material(box(low, high), random));
  }
  if (random.one_in(3)) sheets.push_back(of_some_material(lattice_box(random), random));
  return union_of(std::move(sheets));
}

Shape oblique_cell(Random& random) {
  std::vector<Shape> planes;
  const std::uint64_t count = 3 + random.below(5);
  for (std::uint64_t i = 0; i < count; ++i) {
    const Vector normal{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    planes.push_back(
        of_some_material(half_space(normal[0], normal[1], normal[2], random.uniform(0, 2)), random));
  }
  return random.one_in(5) ? union_of(std::move(planes)) : intersection_of(std::move(planes));
}

}  // namespace groundtruth::cases
