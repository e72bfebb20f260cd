#include <groundtruth/exact/wheel/clipping.hpp>

namespace groundtruth::exact {
namespace {

// F' and the surface's axes, with every root kept apart: r = sqrt(r_squared), X = along_x / r, and so on.
struct ForceOnSurface {
  Rational r_squared;       // n_x^2 + n_z^2
  Rational n_squared;       // ||n||^2
  RationalVector along_x;   // r X
  Rational x_times_r;       // r F'_x
  RationalVector y_part;    // F'_y Y
  Rational y_times_rn;      // r ||n|| F'_y
  RationalVector along_y;   // r ||n|| Y
  RationalVector z_part;    // F'_z Z
  Rational x_squared;       // F'_x^2
  Rational y_squared;       // F'_y^2
  Rational normal_squared;  // N^2
};

ForceOnSurface on_surface(const RationalVector& force, const RationalVector& n) {
  ForceOnSurface f;
  f.r_squared = n.x() * n.x() + n.z() * n.z();
  f.n_squared = n * n;
  f.along_x = RationalVector(-n.z(), 0, n.x());
  f.along_y = RationalVector(-n.x() * n.y(), f.r_squared, -n.y() * n.z());
  f.x_times_r = force * f.along_x;
  f.y_times_rn = force * f.along_y;
  const Rational rn_squared = f.r_squared * f.n_squared;
  const Rational along_normal = force * n;
  f.y_part = f.along_y * Rational(f.y_times_rn / rn_squared);
  f.z_part = n * Rational(along_normal / f.n_squared);
  f.x_squared = f.x_times_r * f.x_times_r / f.r_squared;
  f.y_squared = f.y_times_rn * f.y_times_rn / rn_squared;
  f.normal_squared = along_normal * along_normal / f.n_squared;
  return f;
}

std::shared_ptr<const Radicands> radicands(const Rational& a, const Rational& d) {
  return std::make_shared<const Radicands>(Radicands{a, d});
}

// sign(F'_x) B X = sign(F'_x) (B / r^2) along_x sqrt(r^2).
RationalVector brake_along_x(const ForceOnSurface& f, const Rational& brake) {
  return f.along_x * Rational(sign(f.x_times_r) * brake / f.r_squared);
}

}  // namespace

bool is_upright(const RationalVector& n, const Rational& min_uprightness) {
  if (sign(n.z()) >= 0) return false;
  const Rational level = n.x() * n.x() + n.y() * n.y();
  return n.z() * n.z() >= min_uprightness * min_uprightness * level;
}

ExactClip clip_force(const RationalVector& force, const RationalVector& normal, const PebbleBorder& border) {
  const ForceOnSurface f = on_surface(force, normal);
  const Rational brake_squared = border.brake * border.brake;
  const Rational disc_squared = border.friction * border.friction * f.normal_squared;  // (mu N)^2
  const Rational tangential_squared = f.x_squared + f.y_squared;
  if (f.x_squared <= brake_squared && tangential_squared <= disc_squared) return {Grip::stick, {force}};

  const bool band_cuts_disc = brake_squared < disc_squared;
  const Rational s_squared = disc_squared - brake_squared;
  if (band_cuts_disc && f.y_squared <= s_squared) {
    return {
        Grip::slip,
        {f.y_part + f.z_part, brake_along_x(f, border.brake), CGAL::NULL_VECTOR, radicands(f.r_squared, 0)}};
  }
  if (band_cuts_disc && brake_squared * f.y_squared <= f.x_squared * s_squared) {
    // sign(F'_y) s Y = sign(F'_y) along_y sqrt(s^2 / (r^2 n^2)).
    return {Grip::slip,
            {f.z_part, brake_along_x(f, border.brake), f.along_y * Rational(sign(f.y_times_rn)),
             radicands(f.r_squared, s_squared / (f.r_squared * f.n_squared))}};
  }
  // mu N F'_xy / ||F'_xy||; F'_xy is what the force has besides its normal part.
  const RationalVector tangential = force - f.z_part;
  return {Grip::slip,
          {f.z_part, tangential, CGAL::NULL_VECTOR, radicands(disc_squared / tangential_squared, 0)}};
}

}  // namespace groundtruth::exact
