#include <groundtruth/definition/force_clip.hpp>
#include <groundtruth/definition/pebble_border.hpp>

namespace groundtruth::definition {

ClippedForce clipped(const Triple<Rational>& force_in_wheel, const Surface& surface, const Rational& friction,
                     const Rational& brake) {
  const Triple<Real> force_in_surface = surface.surface_from_wheel(real(force_in_wheel));
  const TangentForce tangent{force_in_surface[0], force_in_surface[1]};
  const PebbleBorder border{absolute(force_in_surface[2]) * friction, brake};
  if (is_inside(tangent, border)) return {Grip::stick, real(force_in_wheel)};
  const TangentForce held = closest_inside(tangent, border);
  return {Grip::slip, surface.wheel_from_surface({held.x, held.y, force_in_surface[2]})};
}

}  // namespace groundtruth::definition
