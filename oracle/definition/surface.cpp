#include <groundtruth/definition/surface.hpp>

namespace groundtruth::definition {

bool is_too_steep(const Triple<Rational>& n, const Rational& min_uprightness) {
  const Rational across = n[0] * n[0] + n[1] * n[1];
  return n[2] >= 0 || n[2] * n[2] < min_uprightness * min_uprightness * across;
}

Surface::Surface(const Triple<Rational>& normal_in_wheel) {
  const Triple<Real> n = real(normal_in_wheel);
  const Real r = square_root(n[0] * n[0] + n[2] * n[2]);
  const Real length = square_root(dot(n, n));
  x_in_wheel_ = r.inverse() * Triple<Real>{-n[2], 0, n[0]};
  y_in_wheel_ = (r * length).inverse() * Triple<Real>{-n[0] * n[1], r * r, -n[1] * n[2]};
  z_in_wheel_ = length.inverse() * -n;
}

Triple<Real> Surface::surface_from_wheel(const Triple<Real>& in_wheel) const {
  return {dot(x_in_wheel_, in_wheel), dot(y_in_wheel_, in_wheel), dot(z_in_wheel_, in_wheel)};
}

Triple<Real> Surface::wheel_from_surface(const Triple<Real>& in_surface) const {
  return in_surface[0] * x_in_wheel_ + in_surface[1] * y_in_wheel_ + in_surface[2] * z_in_wheel_;
}

}  // namespace groundtruth::definition
