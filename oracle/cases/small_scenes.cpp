#include <groundtruth/cases/small_scenes.hpp>

#include <array>
#include <cmath>
#include <utility>

#include <groundtruth/cases/scene_builders.hpp>
#include <groundtruth/cases/shape_parts.hpp>

#include "small_materials.hpp"
#include "small_shapes.hpp"

namespace groundtruth::cases {
namespace {

constexpr std::array makers{seam_row,
                            slab_stack,
                            tiled_corner,
                            ground_with_things,
                            wedge,
                            parallel_planes,
                            spike,
                            thin_sheets,
                            oblique_cell,
                            nested_expression,
                            wide_expression,
                            many_sided_prism,
                            notched_box,
                            repeated_shape,
                            odd_operands,
                            ground_with_things,
                            nested_expression,
                            interleaved_unions};

Shape wrapped(Shape shape, Random& random) {
  const std::uint64_t depth = 1 + random.below(5);
  for (std::uint64_t i = 0; i < depth; ++i) {
    const bool meets = random.one_in(2);
    std::vector<Shape> parts;
    if (random.one_in(3)) parts.push_back(meets ? Shape{Everything{}} : Shape{Nothing{}});
    parts.push_back(std::move(shape));
    shape = meets ? intersection_of(std::move(parts)) : union_of(std::move(parts));
  }
  return shape;
}

// The same solid, each plane at a length of its own; exactly, where numbers are short.
Shape rescaled(const Shape& shape, Random& random) {
  constexpr double lengths[] = {1, 3, 5, 0.5, 0x1p-12, 0x1p+12};
  return with_each_plane(shape, [&](const HalfSpace& plane) {
    const double length = random.pick(lengths);
    const Vector& n = plane.normal;
    return HalfSpace{{length * n[0], length * n[1], length * n[2]}, length * plane.offset};
  });
}

// The same tree without materials and paint: half-spaces stand bare beside each other.
Shape bare(const Shape& shape) {
  const auto each = [](auto op) {
    for (Shape& operand : op.operands) operand = bare(operand);
    return Shape{std::move(op)};
  };
  if (const auto* op = std::get_if<Union>(&shape.expression)) return each(*op);
  if (const auto* op = std::get_if<Intersection>(&shape.expression)) return each(*op);
  if (const auto* cover = std::get_if<Covered>(&shape.expression)) return bare(*cover->over);
  if (const auto* paint = std::get_if<Painted>(&shape.expression)) return bare(*paint->over);
  return shape;
}

// Planes where people put them: at tenths, which neither doubles nor floats have.
Shape in_tenths(const Shape& shape) {
  return with_each_plane(shape, [](const HalfSpace& plane) {
    return HalfSpace{plane.normal, plane.offset * 0.7};
  });
}

// What a user might do to any shape.
Shape dressed(Shape shape, Random& random) {
  if (random.one_in(4)) shape = bare(shape);
  if (random.one_in(6)) shape = in_tenths(shape);
  if (random.one_in(6)) {
    Shape where = some_region(random);
    shape = painted(random.below(5), std::move(where), std::move(shape));
  }
  if (random.one_in(6)) shape = wrapped(std::move(shape), random);
  if (random.one_in(6)) shape = rescaled(shape, random);
  if (random.one_in(8)) shape = covered(random.below(4), std::move(shape));
  return shape;
}

// From a kilometre to the distance of the sun, where doubles are 2^-13 m apart.
Scene far_away(const Scene& scene, Random& random) {
  const auto far = [&] {
    const double distance = std::ldexp(1.0, static_cast<int>(random.between(10, 37)));
    return random.one_in(3) ? 0.0 : random.sign() * distance;
  };
  const Vector offset{far(), far(), random.one_in(2) ? 0.0 : far()};
  return shifted(scene, offset);
}

}  // namespace

Scene small_scene(Random& random) {
  Shape shape = random.pick(makers)(random);
  Scene scene{some_materials(random), dressed(std::move(shape), random)};
  return random.one_in(6) ? far_away(scene, random) : scene;
}

}  // namespace groundtruth::cases
