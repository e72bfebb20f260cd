// Where paint lies: regions are shapes like any other.

#include <utility>

#include <groundtruth/cases/shape_parts.hpp>

#include "small_shapes.hpp"

namespace groundtruth::cases {
namespace {

Shape simple_region(Random& random) { return random.one_in(2) ? lattice_box(random) : lattice_plane(random); }

Shape odd_region(Random& random) {
  switch (random.below(7)) {
    case 0:
      return {Everything{}};
    case 1:
      return {Nothing{}};
    case 2:
      return random.one_in(2) ? intersection_of({}) : union_of({});
    case 3:
      return half_space(0, 0, 0, random.dyadic(-1, 1, 0));
    case 4:
      return painted(random.below(4), simple_region(random), simple_region(random));
    case 5:
      return of_some_material(simple_region(random), random);
    default:
      return intersection_of({Shape{Everything{}}, union_of({Shape{Nothing{}}, simple_region(random)})});
  }
}

}  // namespace

Shape some_region(Random& random) {
  switch (random.below(3)) {
    case 0:
      return odd_region(random);
    case 1: {
      std::vector<Shape> parts{simple_region(random), simple_region(random)};
      return random.one_in(2) ? intersection_of(std::move(parts)) : union_of(std::move(parts));
    }
    default:
      return simple_region(random);
  }
}

}  // namespace groundtruth::cases
