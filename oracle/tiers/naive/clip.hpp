#pragma once
// Clipping a force (SPEC section 4) in any arithmetic that has roots.

#include <cmath>

#include <groundtruth/problem/answer.hpp>
#include <groundtruth/tiers/naive/arithmetic.hpp>
#include <groundtruth/tiers/naive/vector3.hpp>

namespace groundtruth::tiers::naive {

template <class Real>
bool is_upright(const Vector3<Real>& n, const Real& min_uprightness) {
  return sign_of(n.z) < 0 &&
         sign_of(Real(n.z * n.z - min_uprightness * min_uprightness * (n.x * n.x + n.y * n.y))) >= 0;
}

template <class Real>
Real magnitude(const Real& value) {
  return sign_of(value) < 0 ? Real(Real(0) - value) : value;
}

// Q(n): the columns of the rotation from the surface to the wheel.
template <class Real>
struct SurfaceAxes {
  Vector3<Real> x, y, z;

  explicit SurfaceAxes(const Vector3<Real>& n) {
    const Real zero(0);
    const Real r = Arithmetic<Real>::root(Real(n.x * n.x + n.z * n.z));
    const Real length = Arithmetic<Real>::root(dot(n, n));
    const Real both = r * length;
    x = {(zero - n.z) / r, zero, n.x / r};
    y = {(zero - n.x * n.y) / both, r * r / both, (zero - n.y * n.z) / both};
    z = {(zero - n.x) / length, (zero - n.y) / length, (zero - n.z) / length};
  }

  Vector3<Real> into(const Vector3<Real>& v) const { return {dot(x, v), dot(y, v), dot(z, v)}; }
  Vector3<Real> out_of(const Vector3<Real>& v) const {
    return plus(plus(times(v.x, x), times(v.y, y)), times(v.z, z));
  }
};

template <class Real>
struct Border2 {
  Real friction, brake;
};

// What the border leaves of a force; both in surface coordinates. Absent: it sticks.
template <class Real>
std::optional<Vector3<Real>> slipping_force(const Vector3<Real>& f, const Border2<Real>& border) {
  const Real load = magnitude(f.z), reach = border.friction * load;
  const Real along = magnitude(f.x), across = magnitude(f.y);
  const Real squared = f.x * f.x + f.y * f.y;
  if (!(along > border.brake) && !(squared > reach * reach)) return std::nullopt;
  const Real forward = Real(sign_of(f.x)) * border.brake;
  if (border.brake < reach) {
    const Real s = Arithmetic<Real>::root(Real(reach * reach - border.brake * border.brake));
    if (!(across > s)) return Vector3<Real>{forward, f.y, f.z};
    if (!(border.brake * across > along * s)) return Vector3<Real>{forward, Real(sign_of(f.y)) * s, f.z};
  }
  const Real shrink = reach / Arithmetic<Real>::root(squared);
  return Vector3<Real>{shrink * f.x, shrink * f.y, f.z};
}

template <class Real>
bool is_finite(const Vector3<Real>& v) {
  return std::isfinite(as_double(v.x)) && std::isfinite(as_double(v.y)) && std::isfinite(as_double(v.z));
}

template <class Real>
Vector rounded(const Vector3<Real>& v) {
  return {as_double(v.x), as_double(v.y), as_double(v.z)};
}

template <class Real>
ClipAnswer clip(const ClipAsk& ask) {
  const Vector3<Real> normal = as<Real>(ask.normal_in_wheel);
  if (!is_upright(normal, Real(ask.min_uprightness))) return TooSteep{};
  const SurfaceAxes<Real> surface(normal);
  const Vector3<Real> force = surface.into(as<Real>(ask.force_in_wheel));
  const auto slips = slipping_force(force, Border2<Real>{Real(ask.friction), Real(ask.brake)});
  if (!slips) return Clipped{Grip::stick, ask.force_in_wheel};
  const Vector3<Real> clipped = surface.out_of(*slips);
  if (!is_finite(clipped)) return Refusal{"force leaves the range of doubles"};
  return Clipped{Grip::slip, rounded(clipped)};
}

}  // namespace groundtruth::tiers::naive
