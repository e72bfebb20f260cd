#include <groundtruth/tests/bench/polytope.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace groundtruth::bench {

namespace {

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

class Flattener {
 public:
  std::vector<Cell> cells;

  void add_union(const Shape& shape) {
    if (const auto* over = covered(shape)) return add_union(*over);
    if (const auto* all = std::get_if<Union>(&shape.expression)) {
      for (const Shape& operand : all->operands) add_union(operand);
      return;
    }
    cells.emplace_back();
    add_to_cell(shape);
  }

 private:
  void add_to_cell(const Shape& shape) {
    if (const auto* over = covered(shape)) return add_to_cell(*over);
    if (const auto* half_space = std::get_if<HalfSpace>(&shape.expression)) {
      cells.back().push_back(*half_space);
    } else if (const auto* all = std::get_if<Intersection>(&shape.expression)) {
      for (const Shape& operand : all->operands) add_to_cell(operand);
    } else {
      throw std::invalid_argument("not a union of convex cells");
    }
  }

  static const Shape* covered(const Shape& shape) {
    if (const auto* cover = std::get_if<Covered>(&shape.expression)) return cover->over.get();
    if (const auto* paint = std::get_if<Painted>(&shape.expression)) return paint->over.get();
    return nullptr;
  }
};

// Corners of the planes, by the three that meet there.
class CornerFinder {
 public:
  CornerFinder(std::vector<HalfSpace> planes, double reach) : planes_(std::move(planes)), reach_(reach) {}

  void find(Polytope& polytope, std::vector<std::vector<std::uint32_t>>& corners_of_plane) const {
    corners_of_plane.resize(planes_.size());
    for (std::size_t i = 0; i < planes_.size(); ++i)
      for (std::size_t j = i + 1; j < planes_.size(); ++j)
        for (std::size_t k = j + 1; k < planes_.size(); ++k) {
          Vector corner;
          if (!meet(planes_[i], planes_[j], planes_[k], corner) || !is_in_all(corner)) continue;
          const std::uint32_t number = number_of(corner, polytope.corners);
          for (const std::size_t plane : {i, j, k}) add(corners_of_plane[plane], number);
        }
  }

 private:
  static bool meet(const HalfSpace& a, const HalfSpace& b, const HalfSpace& c, Vector& corner) {
    const Vector bc = cross(b.normal, c.normal), ca = cross(c.normal, a.normal),
                 ab = cross(a.normal, b.normal);
    const double determinant = dot(a.normal, bc);
    if (std::abs(determinant) < 1e-12) return false;
    for (std::size_t axis = 0; axis < 3; ++axis)
      corner[axis] = (a.offset * bc[axis] + b.offset * ca[axis] + c.offset * ab[axis]) / determinant;
    return true;
  }

  bool is_in_all(const Vector& x) const {
    return std::all_of(planes_.begin(), planes_.end(), [&](const HalfSpace& plane) {
      return dot(plane.normal, x) - plane.offset <=
             1e-9 * reach_ * std::sqrt(dot(plane.normal, plane.normal));
    });
  }

  std::uint32_t number_of(const Vector& x, std::vector<Vector>& corners) const {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vector apart = minus(x, corners[i]);
      if (dot(apart, apart) < 1e-12 * reach_) return static_cast<std::uint32_t>(i);
    }
    corners.push_back(x);
    return static_cast<std::uint32_t>(corners.size() - 1);
  }

  static void add(std::vector<std::uint32_t>& numbers, std::uint32_t number) {
    if (std::find(numbers.begin(), numbers.end(), number) == numbers.end()) numbers.push_back(number);
  }

  std::vector<HalfSpace> planes_;
  double reach_;
};

void add_face(Polytope& polytope, const Vector& normal, std::vector<std::uint32_t> corners) {
  if (corners.size() < 3) return;
  const Vector origin = polytope.corners[corners.front()];
  Vector centre{};
  for (const std::uint32_t corner : corners)
    for (std::size_t axis = 0; axis < 3; ++axis)
      centre[axis] += polytope.corners[corner][axis] / static_cast<double>(corners.size());
  const Vector across = minus(origin, centre), along = cross(normal, across);
  const double stretch = std::sqrt(dot(along, along) / dot(across, across));
  const auto angle = [&](std::uint32_t corner) {
    const Vector at = minus(polytope.corners[corner], centre);
    return std::atan2(dot(along, at), stretch * dot(across, at));
  };
  std::sort(corners.begin(), corners.end(),
            [&](std::uint32_t a, std::uint32_t b) { return angle(a) < angle(b); });
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    polytope.triangles.push_back({corners[0], corners[i], corners[i + 1]});
}

}  // namespace

std::vector<Cell> cells_of(const Scene& scene) {
  Flattener flattener;
  flattener.add_union(scene.shape);
  return std::move(flattener.cells);
}

Polytope polytope_of(const Cell& cell, double reach) {
  std::vector<HalfSpace> planes = cell;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const double sign : {1.0, -1.0}) {
      HalfSpace limit{{}, reach};
      limit.normal[axis] = sign;
      planes.push_back(limit);
    }
  Polytope polytope;
  std::vector<std::vector<std::uint32_t>> corners_of_plane;
  CornerFinder(planes, reach).find(polytope, corners_of_plane);
  for (std::size_t i = 0; i < planes.size(); ++i) add_face(polytope, planes[i].normal, corners_of_plane[i]);
  return polytope;
}

}  // namespace groundtruth::bench
