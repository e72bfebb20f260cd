#include <groundtruth/as_written/clip.hpp>
#include <groundtruth/as_written/surface_frame.hpp>
#include <groundtruth/as_written/vector_algebra.hpp>

#include <cmath>

namespace groundtruth::as_written {
namespace {

// A force in the surface frame and the border it is held against, in a unit in which the force's largest
// component is near 1: no square of it then overflows.
struct Load {
  Vector force_in_surface;
  double horizontal;  // |F'_xy|
  double friction;    // mu
  double reach;       // mu |F'_z|, the radius of the circle
  double brake;       // B, half the width of the band
};

bool sticks(const Load& load, double force_along_band) {
  return std::fabs(force_along_band) <= load.brake && load.horizontal <= load.reach;
}

// Clips F'_xy; F'_z stays.
Vector clipped_in_surface(const Load& load, const Errata& errata) {
  const auto [x, y, z] = load.force_in_surface;
  if (load.brake < load.reach) {
    const double side = std::sqrt((load.reach - load.brake) * (load.reach + load.brake));
    if (std::fabs(y) <= side) {
      return {std::copysign(load.brake, x), y, z};
    }
    if (load.brake * std::fabs(y) <= std::fabs(x) * side) {
      return {std::copysign(load.brake, x), std::copysign(side, y), z};
    }
  }
  // Only Erratum::band_test_wheel_x brings a force without a horizontal part here.
  if (load.horizontal == 0) {
    return {0, 0, z};
  }
  const double reach = errata.has(Erratum::signed_normal_force) ? load.friction * z : load.reach;
  return {reach * (x / load.horizontal), reach * (y / load.horizontal), z};
}

}  // namespace

ClipAnswer clip(const ClipAsk& ask, const Errata& errata) {
  const std::optional<Axes> wheel_from_surface =
      surface_frame(ask.normal_in_wheel, ask.min_uprightness, errata);
  if (!wheel_from_surface) {
    return TooSteep{};
  }
  const int exponent = exponent_of(ask.force_in_wheel);
  const Vector force_in_wheel = scaled(ask.force_in_wheel, -exponent);
  const Vector force_in_surface = into(*wheel_from_surface, force_in_wheel);
  const Load load{force_in_surface, length(force_in_surface[0], force_in_surface[1]), ask.friction,
                  ask.friction * std::fabs(force_in_surface[2]), std::scalbn(ask.brake, -exponent)};
  const double force_along_band =
      errata.has(Erratum::band_test_wheel_x) ? force_in_wheel[0] : force_in_surface[0];
  if (sticks(load, force_along_band)) {
    return Clipped{Grip::stick, ask.force_in_wheel};
  }
  const Vector clipped = scaled(out_of(*wheel_from_surface, clipped_in_surface(load, errata)), exponent);
  if (!is_finite(clipped)) {
    return Refusal{"the clipped force leaves the range of doubles"};
  }
  return Clipped{Grip::slip, clipped};
}

}  // namespace groundtruth::as_written
