#include <groundtruth/cases/degenerate_scenes.hpp>
#include <groundtruth/cases/ground_materials.hpp>
#include <groundtruth/cases/scene_builders.hpp>
#include <groundtruth/cases/shape_parts.hpp>

namespace groundtruth::cases {
namespace {

// One plane written at three lengths and in three materials, met and joined.
Shape one_plane_many_times() {
  const Shape met =
      intersection_of({covered(dry, half_space(0, 0, 1, 1)), covered(wet, half_space(0, 0, 3, 3)),
                       covered(icy, half_space(0, 0, 0.1, 0.1))});
  const Shape joined = union_of({half_space(1, 0, 2, 0), covered(dirty, half_space(2, 0, 4, 0)),
                                 covered(wet, half_space(0.5, 0, 1, 0))});
  return union_of(
      {intersection_of({met, half_space(-1, 0, 0, 0)}), intersection_of({joined, half_space(1, 0, 0, 0)})});
}

// All of space, with a seam that is no face.
Shape seam_in_everything() {
  return union_of({covered(dry, half_space(1, 0, 0, 0)), covered(wet, half_space(-1, 0, 0, 0))});
}

// x <= 0 and x >= 1: nothing, though each half is entered on the way (erratum single-pass-intersection).
Shape empty_gap() {
  return covered(dry, intersection_of({half_space(1, 0, 0, 0), half_space(-1, 0, 0, -1)}));
}

// {x <= 0} or {x <= 1}: the plane x = 0 is inside (erratum normal-by-order).
Shape buried_plane() {
  return union_of({covered(dry, half_space(1, 0, 0, 0)), covered(wet, half_space(1, 0, 0, 1))});
}

// Eight boxes around a point, of eight materials or none, without the one at +++.
Shape boxes_around_a_corner() {
  return union_of({covered(dry, box({-1, -1, -1}, {0, 0, 0})), covered(wet, box({0, -1, -1}, {1, 0, 0})),
                   covered(icy, box({-1, 0, -1}, {0, 1, 0})), box({0, 0, -1}, {1, 1, 0}),
                   covered(dirty, box({-1, -1, 0}, {0, 0, 1})), covered(water, box({0, -1, 0}, {1, 0, 1})),
                   covered(glass, box({-1, 0, 0}, {0, 1, 1}))});
}

// Boxes that touch in an edge and in a corner only.
Shape barely_touching_boxes() {
  return union_of({covered(dry, box({0, 0, 0}, {1, 1, 1})), covered(wet, box({1, 1, 0}, {2, 2, 1})),
                   covered(icy, box({-1, -1, 1}, {0, 0, 2}))});
}

// Eight planes through one apex, and one that only touches it.
Shape spire() {
  return covered(dry,
                 intersection_of({half_space(2, 0, 1, 4), half_space(-2, 0, 1, 4), half_space(0, 2, 1, 4),
                                  half_space(0, -2, 1, 4), half_space(1, 1, 1, 4), half_space(-1, 1, 1, 4),
                                  half_space(1, -1, 1, 4), half_space(-1, -1, 1, 4), half_space(0, 0, 1, 4),
                                  half_space(0, 0, -1, 0)}));
}

// The same box three times: twice in a union, with other materials, and met with itself.
Shape repeated_box() {
  const Shape once = box({-1, -1, -1}, {1, 1, 1});
  return union_of(
      {covered(dry, once), covered(wet, once), intersection_of({once, covered(icy, once), once})});
}

// Two materials side by side on one plane, and paint whose rim is the seam.
Shape painted_seam() {
  return painted(
      wet, half_space(1, 0, 0, 0),
      union_of({covered(dry, box({-4, -2, -1}, {0, 2, 0})), covered(dirty, box({0, -2, -1}, {4, 2, 0}))}));
}

}  // namespace

std::vector<Scene> coincident_scenes() {
  return {{ground_materials(), one_plane_many_times()},
          {ground_materials(), seam_in_everything()},
          {ground_materials(), empty_gap()},
          {ground_materials(), buried_plane()},
          {ground_materials(), boxes_around_a_corner()},
          {ground_materials(), barely_touching_boxes()},
          {ground_materials(), spire()},
          {ground_materials(), repeated_box()},
          {ground_materials(), painted_seam()}};
}

}  // namespace groundtruth::cases
