#include "small_materials.hpp"

#include <groundtruth/cases/ground_materials.hpp>

namespace groundtruth::cases {
namespace {

Friction some_friction(Random& random) {
  constexpr double coefficients[] = {0, 0.0625, 0.3, 0.7, 0.9, 1, 1.5, 2};
  return {random.pick(coefficients), random.pick(coefficients)};
}

}  // namespace

std::vector<Material> some_materials(Random& random) {
  constexpr double limits[] = {0, 1000, 20000, 1e6, 1e9, 1e300};
  std::vector<Material> materials = ground_materials();
  if (random.one_in(2)) return materials;
  for (Material& material : materials) {
    for (auto& [tyre, friction] : material.friction_by_tyre)
      if (random.one_in(2)) friction = some_friction(random);
    for (const char* tyre : {"Rubber", "rubber2"})
      if (random.one_in(2)) material.friction_by_tyre[tyre] = some_friction(random);
    if (random.one_in(3)) material.maximum_force = random.pick(limits);
    if (random.one_in(6)) material.maximum_force.reset();
  }
  return materials;
}

}  // namespace groundtruth::cases
