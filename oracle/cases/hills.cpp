#include <cstdlib>
#include <utility>
#include <vector>

#include <groundtruth/cases/ground_materials.hpp>
#include <groundtruth/cases/scene_builders.hpp>
#include <groundtruth/cases/shape_parts.hpp>

namespace groundtruth::cases {
namespace {

constexpr double side = 8;  // m, of a square; a power of two, so that slopes are dyadic

// Distance of `i` from the nearest multiple of `period`.
std::int64_t tent(std::int64_t i, std::int64_t period) {
  const std::int64_t rest = i % period;
  return rest < period - rest ? rest : period - rest;
}

// Two ranges of hills that cross, cut off at sea level: some tops are flat over several prisms.
double height(std::size_t i, std::size_t j) {
  const auto x = static_cast<std::int64_t>(i);
  const auto y = static_cast<std::int64_t>(j);
  const std::int64_t quarters = 3 * tent(x + y, 16) + 2 * tent(x + 3 * y, 20) - 18;
  return static_cast<double>(quarters < 0 ? 0 : quarters) / 4;
}

// The plane through (x, y, z) with the given slopes, as the top of a prism.
Shape top(double x, double y, double z, double slope_x, double slope_y) {
  return half_space(0 - slope_x, 0 - slope_y, 1, z - slope_x * x - slope_y * y);
}

// The half of square (i, j) below its diagonal, y - y_j <= x - x_i, and the half above it.
Shape lower_prism(std::size_t i, std::size_t j) {
  const double x = side * static_cast<double>(i);
  const double y = side * static_cast<double>(j);
  const double slope_x = (height(i + 1, j) - height(i, j)) / side;
  const double slope_y = (height(i + 1, j + 1) - height(i + 1, j)) / side;
  return intersection_of({half_space(1, 0, 0, x + side), half_space(0, -1, 0, 0 - y),
                          half_space(-1, 1, 0, y - x), half_space(0, 0, -1, 8),
                          top(x, y, height(i, j), slope_x, slope_y)});
}

Shape upper_prism(std::size_t i, std::size_t j) {
  const double x = side * static_cast<double>(i);
  const double y = side * static_cast<double>(j);
  const double slope_x = (height(i + 1, j + 1) - height(i, j + 1)) / side;
  const double slope_y = (height(i, j + 1) - height(i, j)) / side;
  return intersection_of({half_space(-1, 0, 0, 0 - x), half_space(0, 1, 0, y + side),
                          half_space(1, -1, 0, x - y), half_space(0, 0, -1, 8),
                          top(x, y, height(i, j), slope_x, slope_y)});
}

}  // namespace

Scene hills_of(std::size_t cells) {
  std::vector<Shape> prisms;
  prisms.reserve(2 * cells * cells);
  for (std::size_t j = 0; j < cells; ++j) {
    for (std::size_t i = 0; i < cells; ++i) {
      const MaterialIndex material = (i + j) % 3 == 0 ? dirty : dry;
      prisms.push_back(covered(material, lower_prism(i, j)));
      prisms.push_back(covered(material, upper_prism(i, j)));
    }
  }
  return {ground_materials(), painted(icy, half_space(0, 0, -1, -2.5), union_of(std::move(prisms)))};
}

}  // namespace groundtruth::cases
