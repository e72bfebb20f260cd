#include <cmath>

#include <groundtruth/cases/degenerate_scenes.hpp>
#include <groundtruth/cases/ground_materials.hpp>
#include <groundtruth/cases/scene_builders.hpp>
#include <groundtruth/cases/shape_parts.hpp>

namespace groundtruth::cases {
namespace {

Shape sheet() { return box({-2, -2, 0}, {2, 2, 0}); }

Shape endless_sheet() { return intersection_of({half_space(0, 0, 1, 1), half_space(0, 0, -1, -1)}); }

Shape needle() { return box({0, 0, 0}, {0, 0, 4}); }

Shape point() { return box({1, 2, 3}, {1, 2, 3}); }

// An edge of no thickness along (1, 2, -1), cut from four oblique planes.
Shape oblique_needle() {
  return intersection_of({half_space(1, 0, 1, 0), half_space(-1, 0, -1, 0), half_space(2, -1, 0, 0),
                          half_space(-2, 1, 0, 0), half_space(0, 0, 1, 2), half_space(0, 0, -1, 2)});
}

// A wedge whose angle is about 2^-30.
Shape sliver() {
  return intersection_of({half_space(0, 0, 1, 0), half_space(0x1p-30, 0, -1, 0), half_space(-1, 0, 0, 8),
                          half_space(0, 1, 0, 4), half_space(0, -1, 0, 4)});
}

// Two boxes that miss each other by one ulp.
Shape cracked_floor() {
  return union_of({covered(dry, box({-3, -3, -1}, {1, 3, 0})),
                   covered(wet, box({std::nextafter(1.0, 2.0), -3, -1}, {5, 3, 0}))});
}

// Two boxes that overlap by one ulp, and a third whose top is one ulp higher.
Shape ragged_floor() {
  return union_of({covered(dry, box({-3, -3, -1}, {std::nextafter(1.0, 2.0), 3, 1})),
                   covered(wet, box({1, -3, -1}, {5, 3, 1})),
                   covered(icy, box({5, -3, -1}, {9, 3, std::nextafter(1.0, 2.0)}))});
}

// A sheet that lies on a box, and one that stands out of it.
Shape fins() {
  return union_of({covered(dry, box({-2, -2, -1}, {2, 2, 0})), covered(icy, box({-1, -1, 0}, {3, 1, 0})),
                   covered(wet, box({0, -2, -1}, {0, 2, 3}))});
}

// Three sheets that meet in a point, with nothing but the sheets around it.
Shape crossed_sheets() {
  return union_of({covered(dry, box({-2, -2, 0}, {2, 2, 0})), covered(wet, box({-2, 0, -2}, {2, 0, 2})),
                   covered(dirty, box({0, -2, -2}, {0, 2, 2}))});
}

}  // namespace

std::vector<Scene> thin_scenes() {
  return {{ground_materials(), covered(dry, sheet())},
          {ground_materials(), endless_sheet()},
          {ground_materials(), union_of({covered(dry, needle()), covered(wet, point())})},
          {ground_materials(), covered(dirty, oblique_needle())},
          {ground_materials(), covered(dry, sliver())},
          {ground_materials(), cracked_floor()},
          {ground_materials(), ragged_floor()},
          {ground_materials(), fins()},
          {ground_materials(), crossed_sheets()}};
}

}  // namespace groundtruth::cases
