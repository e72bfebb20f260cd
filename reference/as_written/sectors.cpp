#include <groundtruth/as_written/sectors.hpp>
#include <groundtruth/as_written/vector_algebra.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace groundtruth::as_written {
namespace {

struct Spoke {
  double turn;  // increases with the angle, from 0 to 4
  Vector direction;
};

// A rational stand-in for the angle: exact numbers give coinciding spokes the same bits, and one number a
// spoke always sorts.
double turn_of(double x, double y) {
  const double sum = std::fabs(x) + std::fabs(y);
  const double slope = sum == 0 ? 0 : y / sum;
  if (x < 0) {
    return 2 - slope;
  }
  return slope < 0 ? 4 + slope : slope;
}

std::vector<Spoke> spokes_of(const std::vector<Vector>& lines, const Vector& x_axis, const Vector& y_axis) {
  std::vector<Spoke> spokes;
  spokes.reserve(2 * lines.size());
  for (const Vector& line : lines) {
    const double x = dot(line, x_axis);
    const double y = dot(line, y_axis);
    spokes.push_back({turn_of(x, y), line});
    spokes.push_back({turn_of(-x, -y), times(-1, line)});
  }
  std::sort(spokes.begin(), spokes.end(), [](const Spoke& a, const Spoke& b) { return a.turn < b.turn; });
  const auto same_turn = [](const Spoke& a, const Spoke& b) { return a.turn == b.turn; };
  spokes.erase(std::unique(spokes.begin(), spokes.end(), same_turn), spokes.end());
  return spokes;
}

}  // namespace

std::vector<Vector> sectors_of_plane(const Vector& normal, const std::vector<Vector>& other_normals) {
  std::vector<Vector> lines;
  lines.reserve(other_normals.size());
  for (const Vector& other : other_normals) {
    lines.push_back(scaled_near_one(cross(normal, other)));
  }
  if (lines.empty()) {
    // Perpendicular to the normal, and not zero: it leaves out one of the normal's smaller components.
    return {std::fabs(normal[0]) < std::fabs(normal[1]) ? Vector{0, -normal[2], normal[1]}
                                                        : Vector{-normal[2], 0, normal[0]}};
  }
  const Vector across = scaled_near_one(cross(normal, lines.front()));
  const std::vector<Spoke> spokes = spokes_of(lines, lines.front(), across);
  if (spokes.size() == 2) {
    return {across, times(-1, across)};
  }
  std::vector<Vector> sectors;
  sectors.reserve(spokes.size());
  for (std::size_t i = 0; i < spokes.size(); ++i) {
    sectors.push_back(plus(spokes[i].direction, spokes[(i + 1) % spokes.size()].direction));
  }
  return sectors;
}

}  // namespace groundtruth::as_written
