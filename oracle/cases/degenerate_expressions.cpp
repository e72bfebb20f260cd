#include <utility>

#include <groundtruth/cases/degenerate_scenes.hpp>
#include <groundtruth/cases/ground_materials.hpp>
#include <groundtruth/cases/scene_builders.hpp>
#include <groundtruth/cases/shape_parts.hpp>

namespace groundtruth::cases {
namespace {

// A box cut in two by an intersection of unions: (left or right) and (front or back) and slab.
Shape crossing_unions() {
  return intersection_of(
      {union_of({covered(dry, half_space(1, 0, 0, -1)), covered(wet, half_space(-1, 0, 0, -1))}),
       union_of({covered(icy, half_space(0, 1, 0, -1)), covered(dirty, half_space(0, -1, 0, -1))}),
       half_space(0, 0, 1, 2), half_space(0, 0, -1, 2), box({-4, -4, -4}, {4, 4, 4})});
}

// Union in intersection in union ... five deep, of half-spaces that share planes.
Shape there_and_back() {
  Shape shape = half_space(0, 0, 1, 0);
  for (int level = 1; level <= 5; ++level) {
    const double step = level;
    shape = intersection_of({std::move(shape), half_space(1, 0, 0, step), half_space(1, 0, 1, step)});
    shape = union_of({half_space(1, 0, 0, -step), std::move(shape), half_space(1, 0, 1, -step)});
  }
  return covered(dry, std::move(shape));
}

// One box inside sixty-four nested operands of one.
Shape deep_onion() {
  Shape shape = covered(icy, box({-1, -2, -3}, {3, 2, 1}));
  for (int level = 0; level < 32; ++level) {
    shape = intersection_of({std::move(shape)});
    shape = union_of({std::move(shape)});
  }
  return shape;
}

// Empty operands beside real ones; all of them vanish but the box.
Shape empty_operands() {
  return union_of(
      {union_of({}),
       {Nothing{}},
       intersection_of({union_of({}), half_space(1, 0, 0, 0)}),
       intersection_of({intersection_of({}), {Everything{}}, covered(dry, box({0, 0, 0}, {1, 1, 1}))})});
}

Shape empty_union() { return union_of({}); }

Shape empty_intersection() { return intersection_of({}); }

Shape covered_nothing_or_everything() {
  return union_of(
      {covered(dry, {Nothing{}}), intersection_of({covered(wet, {Everything{}}), half_space(0, 0, 1, 0)})});
}

// Steps written as a union of growing boxes: most faces are partly inside another box.
Shape stairs() {
  Shape steps = union_of({});
  for (int i = 0; i < 6; ++i) {
    const double end = 6 - i;
    const double rise = i + 1;
    steps = union_of({std::move(steps), box({0, 0, 0}, {end, 3, rise})});
  }
  return covered(dirty, std::move(steps));
}

// The same stairs from the other side: an intersection of unions of two half-spaces.
Shape stairs_by_corners() {
  std::vector<Shape> corners{half_space(-1, 0, 0, 0), half_space(0, -1, 0, 0), half_space(0, 1, 0, 3),
                             half_space(0, 0, -1, 0), half_space(1, 0, 0, 6),  half_space(0, 0, 1, 6)};
  for (int i = 1; i < 6; ++i) {
    const double end = 6 - i;
    const double rise = i;
    corners.push_back(union_of({half_space(1, 0, 0, end), half_space(0, 0, 1, rise)}));
  }
  return covered(dry, intersection_of(std::move(corners)));
}

// Paint in paint in cover: the outermost decides, and regions may be odd shapes themselves.
Shape layers_of_paint() {
  const Shape stripe = intersection_of({half_space(1, 0, 0, 1), half_space(-1, 0, 0, 1)});
  const Shape nowhere = intersection_of({half_space(1, 0, 0, 0), half_space(-1, 0, 0, -1)});
  const Shape point = box({2, 2, 0}, {2, 2, 0});
  const Shape ground = painted(icy, stripe, covered(dry, half_space(0, 0, 1, 0)));
  return painted(water, point, painted(glass, nowhere, painted(wet, half_space(0, 1, 0, 0), ground)));
}

}  // namespace

std::vector<Scene> odd_expression_scenes() {
  return {{ground_materials(), crossing_unions()}, {ground_materials(), there_and_back()},
          {ground_materials(), deep_onion()},      {ground_materials(), empty_operands()},
          {ground_materials(), empty_union()},     {ground_materials(), empty_intersection()},
          {ground_materials(), stairs()},          {ground_materials(), stairs_by_corners()},
          {ground_materials(), layers_of_paint()}, {ground_materials(), covered_nothing_or_everything()}};
}

}  // namespace groundtruth::cases
