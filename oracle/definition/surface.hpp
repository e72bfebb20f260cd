#pragma once
// Surfaces as a wheel sees them (SPEC section 4).

#include <groundtruth/definition/real.hpp>

namespace groundtruth::definition {

// Whether the outward normal leaves the orientation on the surface without meaning. Requires min_uprightness
// > 0.
bool is_too_steep(const Triple<Rational>& normal_in_wheel, const Rational& min_uprightness);

// The orientation Q on a surface: x the rolling direction, z into the ground.
class Surface {
 public:
  // Requires a normal that is not too steep.
  explicit Surface(const Triple<Rational>& normal_in_wheel);

  Triple<Real> surface_from_wheel(const Triple<Real>& in_wheel) const;
  Triple<Real> wheel_from_surface(const Triple<Real>& in_surface) const;

 private:
  Triple<Real> x_in_wheel_, y_in_wheel_, z_in_wheel_;
};

}  // namespace groundtruth::definition
