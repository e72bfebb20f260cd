#include <optional>
#include <stdexcept>
#include <vector>

#include <groundtruth/definition/pebble_border.hpp>

namespace groundtruth::definition {
namespace {

Real squared_length(const TangentForce& f) { return f.x * f.x + f.y * f.y; }

// The closest point is one of these: in the inside; on the disc's rim; on an edge of the band; where both
// meet.
std::vector<TangentForce> candidates(const TangentForce& force, const PebbleBorder& border) {
  const auto& [radius, half_width] = border;
  std::vector<TangentForce> result{force, {half_width, force.y}, {-half_width, force.y}};
  const Real length = square_root(squared_length(force));
  if (length.sign() > 0) {
    const Real shrinking = radius / length;
    result.push_back({shrinking * force.x, shrinking * force.y});
  }
  const Real corner_squared = radius * radius - half_width * half_width;
  if (corner_squared.sign() >= 0) {
    const Real corner = square_root(corner_squared);
    for (const Real& x : {half_width, -half_width})
      for (const Real& y : {corner, -corner}) result.push_back({x, y});
  }
  return result;
}

}  // namespace

bool is_inside(const TangentForce& force, const PebbleBorder& border) {
  return absolute(force.x) <= border.half_width && squared_length(force) <= border.radius * border.radius;
}

TangentForce closest_inside(const TangentForce& force, const PebbleBorder& border) {
  std::optional<TangentForce> best;
  std::optional<Real> least;
  for (const TangentForce& candidate : candidates(force, border)) {
    if (!is_inside(candidate, border)) continue;
    const Real distance = squared_length({candidate.x - force.x, candidate.y - force.y});
    if (least && distance >= *least) continue;
    best = candidate;
    least = distance;
  }
  if (!best) throw std::logic_error("definition: no candidate lies inside the pebble border");
  return *best;
}

}  // namespace groundtruth::definition
