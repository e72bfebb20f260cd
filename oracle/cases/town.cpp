#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <groundtruth/cases/ground_materials.hpp>
#include <groundtruth/cases/random.hpp>
#include <groundtruth/cases/scene_builders.hpp>
#include <groundtruth/cases/shape_parts.hpp>
#include <groundtruth/cases/vector_arithmetic.hpp>

namespace groundtruth::cases {
namespace {

constexpr double plot = 24;  // m, the side of the square that a house stands in

struct Plan {
  Vector centre{};    // on the ground
  Vector along{};     // the direction across the ridge; not of unit length if the house is turned
  Vector sideways{};  // of the same length, at a right angle
  double half_width = 0;
  double half_length = 0;
  double wall = 0;   // m, the height of the eaves
  double slope = 0;  // of the roof
};

// {x : (direction, rise) . (x - centre) <= offset}
Shape wall_or_roof(const Plan& plan, const Vector& direction, double rise, double offset) {
  const Vector normal{direction[0] + 0.0, direction[1] + 0.0, rise};  // no negative zeros
  return half_space(normal[0], normal[1], normal[2], offset + dot(normal, plan.centre));
}

Shape house_of(const Plan& plan) {
  const double scale = length(plan.along);  // exact for the directions that are used
  const Vector across = times(plan.slope, plan.along);
  const double eaves = scale * (plan.wall + plan.slope * plan.half_width);
  return intersection_of({wall_or_roof(plan, times(-1, plan.sideways), 0, scale * plan.half_length),
                          wall_or_roof(plan, plan.sideways, 0, scale * plan.half_length),
                          wall_or_roof(plan, plan.along, 0, scale * plan.half_width),
                          wall_or_roof(plan, times(-1, plan.along), 0, scale * plan.half_width),
                          wall_or_roof(plan, across, scale, eaves),
                          wall_or_roof(plan, times(-1, across), scale, eaves), half_space(0, 0, -1, 0)});
}

Plan random_plan(const Vector& corner_of_plot, Random& random) {
  Plan plan;
  plan.centre = plus(corner_of_plot, {random.dyadic(10, 14, 2), random.dyadic(10, 14, 2), 0});
  plan.half_width = random.dyadic(2, 5, 10);
  plan.half_length = random.dyadic(2, 6, 10);
  plan.wall = random.dyadic(2, 5, 10);
  plan.slope = random.dyadic(1, 8, 0) / 8;
  const std::uint64_t kind = random.below(8);
  if (kind == 0) {
    plan.along = {3, 4, 0};
    plan.sideways = {-4, 3, 0};
  } else if (kind == 1) {
    const double turn = random.uniform(-1, 1);
    plan.along = {1, turn, 0};
    plan.sideways = {-turn, 1, 0};
    plan.slope = random.uniform(0.1, 1);
    plan.wall = random.uniform(2, 5);
  } else {
    plan.along = {1, 0, 0};
    plan.sideways = {0, 1, 0};
  }
  return plan;
}

std::optional<MaterialIndex> material_of_house(std::size_t number) {
  switch (number % 16) {
    case 3:
      return std::nullopt;
    case 7:
      return glass;
    case 11:
      return icy;
    default:
      return number % 2 == 0 ? dry : dirty;
  }
}

}  // namespace

Scene town_of(std::size_t houses, std::uint64_t seed) {
  Random random(seed_of_part(seed, houses));
  std::size_t columns = 1;
  while (columns * columns < houses) ++columns;
  const double side = plot * static_cast<double>(columns);

  // Top faces of paint lie in the ground's plane, so that their rims can be aimed at.
  const Shape road = box({-plot, -4, -1}, {side + plot, 0, 0});
  const Shape puddle = box({-8, -16, -1}, {8, -8, 0});
  std::vector<Shape> parts{painted(water, puddle, painted(wet, road, covered(dry, half_space(0, 0, 1, 0))))};
  parts.reserve(houses + 1);
  for (std::size_t i = 0; i < houses; ++i) {
    const Vector corner{plot * static_cast<double>(i % columns), plot * static_cast<double>(i / columns), 0};
    Shape built = house_of(random_plan(corner, random));
    const std::optional<MaterialIndex> material = material_of_house(i);
    parts.push_back(material ? covered(*material, std::move(built)) : std::move(built));
  }
  return {ground_materials(), union_of(std::move(parts))};
}

}  // namespace groundtruth::cases
