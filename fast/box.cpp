#include <groundtruth/fast/box.hpp>

#include <algorithm>
#include <cmath>

namespace groundtruth::fast {

namespace {

constexpr double unit = 0x1p-53;
constexpr double tiny = 0x1p-1000;  // covers whatever underflows
constexpr std::size_t most_half_spaces = 16;
constexpr double greatest_slack = 0x1p-30;  // more is the work of normals that are nearly dependent

double magnitude(double x) { return std::abs(x); }

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// direction . x <= bound + slack . |x| in the cell, with |x| by coordinate.
struct Bound {
  double bound = unbounded;
  Vector slack{};
};

// A direction along an axis: sign * e_axis.
struct Direction {
  std::size_t axis;
  double sign;
};

constexpr Direction directions[] = {{0, 1}, {0, -1}, {1, 1}, {1, -1}, {2, 1}, {2, -1}};

// By a half-space that looks in this very direction.
Bound bound_by_one(std::span<const HalfSpace> half_spaces, const Direction& direction) {
  Bound best;
  for (const auto& [n, d] : half_spaces) {
    const double along = direction.sign * n[direction.axis];
    const bool looks_along =
        along > 0 && n[(direction.axis + 1) % 3] == 0 && n[(direction.axis + 2) % 3] == 0;
    if (!looks_along) continue;
    const double bound = d / along;
    best.bound = std::min(best.bound, bound + 2 * unit * magnitude(bound) + tiny);
  }
  return best;
}

// By three half-spaces whose normals the direction is a sum of, with weights >= 0.
class ThreeNormals {
 public:
  ThreeNormals(const HalfSpace& a, const HalfSpace& b, const HalfSpace& c) : half_spaces_{&a, &b, &c} {
    cofactors_ = {cross(b.normal, c.normal), cross(c.normal, a.normal), cross(a.normal, b.normal)};
    determinant_ = dot(a.normal, cofactors_[0]);
  }

  bool are_independent() const { return determinant_ != 0 && std::isfinite(determinant_); }

  void lower(Bound& best, const Direction& direction) const {
    Vector weights;
    for (std::size_t i = 0; i < 3; ++i) {
      weights[i] = direction.sign * cofactors_[i][direction.axis] / determinant_;
      if (!(weights[i] >= -0x1p-40)) return;  // a small one may be a rounded zero; any weight >= 0 will do
      weights[i] = std::max(weights[i], 0.0);
    }
    double bound = 0, size = 0;
    Vector rest{}, rest_size{};
    rest[direction.axis] = direction.sign;
    rest_size[direction.axis] = 1;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& [n, d] = *half_spaces_[i];
      bound += weights[i] * d;
      size += magnitude(weights[i] * d);
      for (std::size_t k = 0; k < 3; ++k) {
        rest[k] -= weights[i] * n[k];
        rest_size[k] += magnitude(weights[i] * n[k]);
      }
    }
    bound += 8 * unit * size + tiny;
    if (!(bound < best.bound)) return;
    Vector slack;
    for (std::size_t k = 0; k < 3; ++k) {
      slack[k] = magnitude(rest[k]) + 8 * unit * rest_size[k] + tiny;
      if (!(slack[k] < greatest_slack)) return;
    }
    best = {bound, slack};
  }

 private:
  std::array<const HalfSpace*, 3> half_spaces_;
  std::array<Vector, 3> cofactors_;
  double determinant_;
};

void bound_by_three(std::span<const HalfSpace> half_spaces, std::array<Bound, 6>& bounds,
                    const std::array<bool, 6>& is_wanted) {
  const std::size_t count = std::min(half_spaces.size(), most_half_spaces);
  // Weights >= 0 make no direction of normals of which none looks along it.
  std::array<unsigned, most_half_spaces> looks_along{};  // the wanted directions, as bits
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t at = 0; at < 6; ++at)
      if (is_wanted[at] && directions[at].sign * half_spaces[i].normal[directions[at].axis] > 0)
        looks_along[i] |= 1U << at;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j)
      for (std::size_t k = j + 1; k < count; ++k) {
        if ((looks_along[i] | looks_along[j] | looks_along[k]) == 0) continue;
        const ThreeNormals normals(half_spaces[i], half_spaces[j], half_spaces[k]);
        if (!normals.are_independent()) continue;
        for (std::size_t at = 0; at < 6; ++at)
          if (is_wanted[at]) normals.lower(bounds[at], directions[at]);
      }
}

// Largest coordinate of a point x of the cell: |x| <= max |bound| + 3 greatest_slack |x|. Infinite unless
// every direction is bounded.
double reach_of(const std::array<Bound, 6>& bounds) {
  double reach = 0;
  for (const Bound& one : bounds) reach = std::max(reach, magnitude(one.bound));
  return 2 * reach;
}

}  // namespace

bool Box::is_bounded() const {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!(low[axis] > -unbounded) || !(high[axis] < unbounded)) return false;
  return true;
}

Box hull(const Box& a, const Box& b) {
  Box box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.low[axis] = std::min(a.low[axis], b.low[axis]);
    box.high[axis] = std::max(a.high[axis], b.high[axis]);
  }
  return box;
}

Box intersection(const Box& a, const Box& b) {
  Box box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.low[axis] = std::max(a.low[axis], b.low[axis]);
    box.high[axis] = std::min(a.high[axis], b.high[axis]);
  }
  return box;
}

Box box_around(std::span<const HalfSpace> half_spaces) {
  std::array<Bound, 6> bounds;
  std::array<bool, 6> is_wanted{};
  bool is_any_wanted = false;
  for (std::size_t at = 0; at < 6; ++at) {
    bounds[at] = bound_by_one(half_spaces, directions[at]);
    is_wanted[at] = bounds[at].bound == unbounded;
    is_any_wanted |= is_wanted[at];
  }
  if (is_any_wanted) bound_by_three(half_spaces, bounds, is_wanted);
  const double reach = reach_of(bounds);
  Box box;
  for (std::size_t at = 0; at < 6; ++at) {
    const auto& [bound, slack] = bounds[at];
    double limit = bound;
    for (const double one : slack)
      if (one > 0) limit += one * reach * (1 + 4 * unit);
    limit += 4 * unit * magnitude(limit);
    if (!std::isfinite(limit)) continue;
    const auto& [axis, sign] = directions[at];
    (sign > 0 ? box.high : box.low)[axis] = sign * limit;
  }
  return box;
}

double greatest_delta(const HalfSpace& half_space, const Box& box) {
  double sum = -half_space.offset, size = magnitude(half_space.offset);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double n = half_space.normal[axis];
    if (n == 0) continue;
    const double term = n * (n > 0 ? box.high : box.low)[axis];
    sum += term;
    size += magnitude(term);
  }
  const double greatest = sum + 8 * unit * size + tiny;
  return std::isnan(greatest) ? unbounded : greatest;
}

}  // namespace groundtruth::fast
