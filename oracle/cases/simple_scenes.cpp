// The scenes that are short enough to be read as they stand: house, ramp, runway.

#include <utility>
#include <vector>

#include <groundtruth/cases/ground_materials.hpp>
#include <groundtruth/cases/scene_builders.hpp>
#include <groundtruth/cases/shape_parts.hpp>

namespace groundtruth::cases {

Scene house() {
  return {ground_materials(), covered(dry, intersection_of({half_space(0, -1, 0, 4), half_space(0, 1, 0, 4),
                                                            half_space(1, 0, 0, 3), half_space(-1, 0, 0, 3),
                                                            half_space(1, 0, 1, 7), half_space(-1, 0, 1, 7),
                                                            half_space(0, 0, -1, 0)}))};
}

Scene runway_of(std::size_t boxes) {
  std::vector<Shape> slabs;
  slabs.reserve(boxes);
  for (std::size_t i = 0; i < boxes; ++i) {
    const double begin = 10 * static_cast<double>(i);
    slabs.push_back(box({begin, -15, -1}, {begin + 10, 15, 0}));
  }
  // The patch's top face lies in the runway's, so that its rim can be aimed at.
  const auto third = 10 * static_cast<double>(boxes / 3);
  const Shape patch = box({third + 4, -5, -1}, {2 * third + 6, 5, 0});
  return {ground_materials(), painted(wet, patch, covered(dry, union_of(std::move(slabs))))};
}

Scene ramp() {
  const Shape flat = covered(dry, box({-20, -10, -1}, {0, 10, 0}));
  const Shape slope = covered(
      dry, intersection_of({half_space(-1, 0, 0, 0), half_space(1, 0, 0, 20), half_space(0, -1, 0, 10),
                            half_space(0, 1, 0, 10), half_space(0, 0, -1, 1), half_space(-1, 0, 4, 0)}));
  const Shape deck = covered(
      dirty, intersection_of({half_space(-1, 0, 0, -20), half_space(1, 0, 0, 30), half_space(0, -1, 0, 10),
                              half_space(0, 1, 0, 10), half_space(0, 0, 1, 5)}));
  const Shape ice = union_of({box({-2, -4, -1}, {2, 4, 1}), box({8, -10, 2}, {12, 0, 3})});
  return {ground_materials(), painted(icy, ice, union_of({flat, slope, deck}))};
}

}  // namespace groundtruth::cases
