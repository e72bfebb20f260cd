#include <limits>

#include <groundtruth/cases/degenerate_scenes.hpp>
#include <groundtruth/cases/ground_materials.hpp>
#include <groundtruth/cases/scene_builders.hpp>
#include <groundtruth/cases/shape_parts.hpp>

namespace groundtruth::cases {
namespace {

constexpr double tiniest = std::numeric_limits<double>::denorm_min();

// A zero normal means everything (d >= 0) or nothing, and counts as a leaf.
Shape zero_normals() {
  const Shape ground = covered(dry, half_space(0, 0, 1, 0));
  return union_of({half_space(0, 0, 0, -1), intersection_of({half_space(0, 0, 0, 0), ground}),
                   intersection_of({half_space(0, 0, 0, -tiniest), half_space(1, 0, 0, 0)}),
                   intersection_of({half_space(0, 0, 0, 5), covered(wet, half_space(1, 0, 1, -2))})});
}

Shape zero_normal_everything() {
  return intersection_of({union_of({half_space(1, 0, 0, 0), half_space(0, 0, 0, 0)}), {Everything{}}});
}

Shape zero_normal_nothing() { return intersection_of({half_space(1, 0, 0, 0), half_space(0, 0, 0, -1)}); }

// A unit box whose planes have lengths from 1e-300 to 1e300.
Shape unequal_normals() {
  return covered(dry, intersection_of({half_space(-0x1p-1000, 0, 0, 0), half_space(0x1p1000, 0, 0, 0x1p1000),
                                       half_space(0, -1e-300, 0, 0), half_space(0, 1e300, 0, 1e300),
                                       half_space(0, 0, -tiniest, 0), half_space(0, 0, tiniest, tiniest)}));
}

// Components of a normal that differ so much that products lose one or the other.
Shape lopsided_normals() {
  return union_of(
      {covered(dry, half_space(1, 0x1p-60, 1, 0)), covered(wet, half_space(1e-160, 1e-160, 1, -1)),
       covered(icy, intersection_of({half_space(0x1p53, 1, 0, 1), half_space(-0x1p53, 0, -1, 1)}))});
}

// Faces where no decimal is a double, so that corners are close to planes and not on them.
Shape tenths() {
  return covered(dry, intersection_of({half_space(0.1, 0.2, 0.3, 0.6), half_space(-0.7, 0.1, 0, 0.3),
                                       half_space(0.1, -0.9, 0.1, 0.7), half_space(0, 0, -0.3, 0.9),
                                       half_space(0.3, 0.3, -0.1, 1.1)}));
}

// Two planes that differ by an ulp in one component and cross at a distance of about 2^52.
Shape nearly_parallel() {
  return intersection_of({covered(dry, half_space(0, 0, 1, 0)), covered(wet, half_space(0x1p-52, 0, 1, 0)),
                          half_space(0, 0, -1, 4)});
}

Shape far_planes() {
  return union_of({covered(dry, half_space(0, 0, 1, -1e300)), covered(wet, half_space(0, 0, 1, -1e15)),
                   covered(icy, box({1e6, 1e6, 0}, {1e6 + 0x1p-10, 1e6 + 0x1p-10, 0x1p-10}))});
}

}  // namespace

std::vector<Scene> odd_plane_scenes() {
  return {{ground_materials(), zero_normals()},        {ground_materials(), zero_normal_everything()},
          {ground_materials(), zero_normal_nothing()}, {ground_materials(), unequal_normals()},
          {ground_materials(), lopsided_normals()},    {ground_materials(), tenths()},
          {ground_materials(), nearly_parallel()},     {ground_materials(), far_planes()}};
}

}  // namespace groundtruth::cases
