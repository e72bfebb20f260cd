#include <cmath>

#include <groundtruth/cases/corners.hpp>
#include <groundtruth/cases/vector_arithmetic.hpp>

namespace groundtruth::cases {
namespace {

bool nearly_in(const Vector& point, const HalfSpace& half_space) {
  const Vector& n = half_space.normal;
  const double size = std::abs(n[0] * point[0]) + std::abs(n[1] * point[1]) + std::abs(n[2] * point[2]) +
                      std::abs(half_space.offset);
  return dot(n, point) - half_space.offset <= 1e-9 * size;
}

bool nearly_in_all(const Vector& point, const std::vector<HalfSpace>& planes) {
  for (const HalfSpace& plane : planes) {
    if (!nearly_in(point, plane)) return false;
  }
  return true;
}

}  // namespace

std::optional<Vector> meeting_point(const HalfSpace& a, const HalfSpace& b, const HalfSpace& c) {
  const Vector bc = cross(b.normal, c.normal);
  const Vector ca = cross(c.normal, a.normal);
  const Vector ab = cross(a.normal, b.normal);
  const double determinant = dot(a.normal, bc);
  const Vector numerator = plus(plus(times(a.offset, bc), times(b.offset, ca)), times(c.offset, ab));
  // Zero determinants and overflows both show here. Adding 0 turns -0 into 0.
  const Vector point{numerator[0] / determinant + 0.0, numerator[1] / determinant + 0.0,
                     numerator[2] / determinant + 0.0};
  if (!std::isfinite(point[0]) || !std::isfinite(point[1]) || !std::isfinite(point[2])) return std::nullopt;
  return point;
}

std::vector<Corner> corners_of(const std::vector<HalfSpace>& planes, std::size_t own_planes, Keep keep) {
  std::vector<Corner> corners;
  for (std::size_t i = 0; i < own_planes; ++i) {
    for (std::size_t j = i + 1; j < planes.size(); ++j) {
      for (std::size_t k = j + 1; k < planes.size(); ++k) {
        const std::optional<Vector> point = meeting_point(planes[i], planes[j], planes[k]);
        if (!point) continue;
        if (keep == Keep::feasible && !nearly_in_all(*point, planes)) continue;
        corners.push_back({*point, {i, j, k}});
      }
    }
  }
  return corners;
}

}  // namespace groundtruth::cases
