#include <memory>
#include <utility>
#include <vector>

#include <groundtruth/cases/ground_materials.hpp>
#include <groundtruth/cases/random.hpp>
#include <groundtruth/cases/scene_builders.hpp>
#include <groundtruth/cases/shape_parts.hpp>

namespace groundtruth::cases {
namespace {

Shape random_half_space(Random& random) {
  const Vector normal{random.dyadic(-2, 2, 0), random.dyadic(-2, 2, 0), random.dyadic(-2, 2, 0)};
  return half_space(normal[0], normal[1], normal[2], random.dyadic(-4, 4, 1));
}

// Thin in a direction now and then, because a size may be zero.
Shape random_box(Random& random) {
  const Vector low{random.dyadic(-3, 3, 0), random.dyadic(-3, 3, 0), random.dyadic(-3, 3, 0)};
  const Vector size{random.dyadic(0, 3, 0), random.dyadic(0, 3, 0), random.dyadic(0, 3, 0)};
  return box(low, {low[0] + size[0], low[1] + size[1], low[2] + size[2]});
}

Shape random_operand(Random& random) {
  const std::uint64_t kind = random.below(24);
  if (kind == 0) return {Everything{}};
  if (kind == 1) return {Nothing{}};
  return kind < 10 ? random_box(random) : random_half_space(random);
}

Shape random_shape(Random& random, unsigned depth, unsigned operands) {
  if (depth == 0) return random_operand(random);
  std::vector<Shape> parts(1 + random.below(operands));
  for (Shape& part : parts) {
    const bool stops_early = random.one_in(4);
    part = stops_early ? random_operand(random) : random_shape(random, depth - 1, operands);
  }
  // Nested the same way twice in a row is allowed: engines may flatten.
  const bool meets = random.one_in(2);
  Shape shape = meets ? intersection_of(std::move(parts)) : union_of(std::move(parts));
  const MaterialIndex material = random.below(6);
  switch (random.below(6)) {
    case 0:
      return covered(material, std::move(shape));
    case 1:
      return painted(material, random_operand(random), std::move(shape));
    default:
      return shape;
  }
}

}  // namespace

Scene random_nested(std::uint64_t seed, unsigned depth, unsigned operands) {
  Random random(seed);
  return {ground_materials(), random_shape(random, depth, operands)};
}

}  // namespace groundtruth::cases
