#pragma once
// A surface at the wheel, and what it does to a force (SPEC section 4), in counted numbers. Not installed.
//
// Whatever takes a decision returns nothing where that is uncertain.

#include <array>

#include <groundtruth/fast/number_counted.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::fast {

template <class Real, int n>
using CountedVector = std::array<Counted<Real, n>, 3>;

template <class Real>
CountedVector<Real, 0> counted(const Vector& v) {
  return {counted<Real>(v[0]), counted<Real>(v[1]), counted<Real>(v[2])};
}

// The nearest doubles; nothing if one of them is uncertain.
template <class Real, int n>
std::optional<Vector> nearest_doubles(const CountedVector<Real, n>& v) {
  Vector rounded{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto component = nearest_double(v[axis]);
    if (!component) return std::nullopt;
    rounded[axis] = *component;
  }
  return rounded;
}

template <class Real, int m, int n>
auto dot(const CountedVector<Real, m>& a, const CountedVector<Real, n>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// a <= b?
template <class Real, int m, int n>
std::optional<bool> is_at_most(const Counted<Real, m>& a, const Counted<Real, n>& b) {
  const Sign sign = sign_of(b - a);
  if (sign == Sign::uncertain) return std::nullopt;
  return sign != Sign::negative;
}

template <class Real, int m, int n>
CountedVector<Real, m + n + 2> cross(const CountedVector<Real, m>& a, const CountedVector<Real, n>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Of a normal as high along the wheel's z axis, downward, and as long as this.
template <class Real, int m, int n>
std::optional<bool> is_upright(const Counted<Real, m>& depth, const Counted<Real, n>& length_squared,
                               double min_uprightness) {
  const Sign side = sign_of(depth);
  if (side == Sign::uncertain) return std::nullopt;
  if (side != Sign::negative) return false;
  const auto t_squared = square(counted<Real>(min_uprightness));
  return is_at_most(t_squared * length_squared, (counted<Real>(1) + t_squared) * square(depth));
}

// Vectors may be in any axes, the same ones for all of a surface.
template <class Real, int b>
struct Grasp {
  CountedVector<Real, 0> normal;  // any length; upright
  Counted<Real, 0> friction;
  Counted<Real, b> brake;
};

// What a clip does: SPEC section 4, stick and cases 1 to 3 of slip.
enum class Clipping { none, onto_band_edge, onto_corner, onto_circle };

// The force along a surface with normal n. `forward`, g, is a positive multiple of X (SPEC section 4):
//   along   = F'_x |g|
//   turning = n x F, of length |F'_xy| |n|
//   across  = F'_y |g| |n|, axis g x n
//   down    = F'_z |n|
// Lemma clipping-without-axes (proofs-notes/rounding-of-forces.md).
template <class Real, int g, int f, int b>
class ForceOnSurface {
 public:
  ForceOnSurface(const Grasp<Real, b>& grasp, const CountedVector<Real, g>& forward,
                 const CountedVector<Real, f>& force)
      : grasp_(grasp),
        forward_(forward),
        force_(force),
        n_squared_(dot(grasp.normal, grasp.normal)),
        g_squared_(dot(forward, forward)),
        along_(dot(forward, force)),
        turning_(cross(grasp.normal, force)),
        across_(dot(forward, turning_)),
        down_(-dot(grasp.normal, force)),
        limit_(grasp.friction * down_) {}

  const auto& down() const { return down_; }
  const auto& n_squared() const { return n_squared_; }

  std::optional<Clipping> decide() const {
    const auto within_band = is_at_most(square(along_), square(grasp_.brake) * g_squared_);
    if (!within_band) return std::nullopt;
    if (!*within_band) return decide_slip();
    const auto within_disc = is_at_most(turning_squared(), square(limit_));
    if (!within_disc) return std::nullopt;
    return *within_disc ? Clipping::none : decide_slip();
  }

  // with(force, in the axes of the vectors), for a clipping that is not `none`. Unlike roundings make unlike
  // types.
  template <class With>
  auto clipped(Clipping clipping, const With& with) const {
    if (clipping == Clipping::onto_band_edge) return with(onto_band_edge());
    if (clipping == Clipping::onto_corner) return with(onto_corner());
    return with(onto_circle());
  }

 private:
  std::optional<Clipping> decide_slip() const {
    const auto corner = corner_squared();
    const Sign corner_sign = sign_of(corner);
    if (corner_sign == Sign::uncertain) return std::nullopt;
    if (corner_sign != Sign::positive) return Clipping::onto_circle;
    const auto between_corners = is_at_most(square(across_), g_squared_ * corner);
    if (!between_corners) return std::nullopt;
    if (*between_corners) return Clipping::onto_band_edge;
    const auto beside_corner = is_at_most(square(grasp_.brake * across_), square(along_) * corner);
    if (!beside_corner) return std::nullopt;
    return *beside_corner ? Clipping::onto_corner : Clipping::onto_circle;
  }

  // The slips of SPEC section 4, cases 1 to 3.
  auto onto_band_edge() const {
    const auto missing = (with_sign_of(along_, grasp_.brake * root(g_squared_)) - along_) / g_squared_;
    const auto axis = [&](std::size_t k) { return force_[k] + missing * forward_[k]; };
    return vector_of(axis);
  }
  auto onto_corner() const {
    const auto inverse_length = one() / root(g_squared_);
    const auto inverse = one() / n_squared_;
    const auto ahead = with_sign_of(along_, grasp_.brake * inverse_length);
    const auto aside = with_sign_of(across_, root(corner_squared()) * inverse_length * inverse);
    const auto pressed = down_ * inverse;
    const auto across_axis = cross(forward_, grasp_.normal);
    const auto axis = [&](std::size_t k) {
      return (ahead * forward_[k] + aside * across_axis[k]) - pressed * grasp_.normal[k];
    };
    return vector_of(axis);
  }
  auto onto_circle() const {
    const auto part = magnitude(limit_) / root(turning_squared());
    const auto pressed = (one() - part) * (down_ / n_squared_);
    const auto axis = [&](std::size_t k) { return part * force_[k] - pressed * grasp_.normal[k]; };
    return vector_of(axis);
  }

  template <class Axis>
  static auto vector_of(const Axis& axis) {
    const auto first = axis(0);
    return CountedVector<Real, decltype(first)::roundings>{first, axis(1), axis(2)};
  }

  // |F'_xy|^2 |n|^2
  auto turning_squared() const { return square(turning_[0]) + square(turning_[1]) + square(turning_[2]); }
  // s^2 |n|^2
  auto corner_squared() const { return square(limit_) - square(grasp_.brake) * n_squared_; }

  // No slip's sign of a component matters where it is uncertain: then the component is 0 (lemma slip-signs).
  template <int m, int k>
  static Counted<Real, k> with_sign_of(const Counted<Real, m>& sign, const Counted<Real, k>& x) {
    const auto approximate = static_cast<double>(sign.value);
    return approximate > 0 ? x : approximate < 0 ? -x : Counted<Real, k>{};
  }

  static Counted<Real, 0> one() { return counted<Real>(1); }

  using Normal = CountedVector<Real, 0>;
  using Forward = CountedVector<Real, g>;
  using Force = CountedVector<Real, f>;
  using Turning = CountedVector<Real, f + 2>;
  using Down = decltype(dot(Normal(), Force()));

  const Grasp<Real, b>& grasp_;
  const Forward& forward_;
  const Force& force_;
  const decltype(dot(Normal(), Normal())) n_squared_;
  const decltype(dot(Forward(), Forward())) g_squared_;
  const decltype(dot(Forward(), Force())) along_;
  const Turning turning_;
  const decltype(dot(Forward(), Turning())) across_;
  const Down down_;
  const decltype(Counted<Real, 0>() * Down()) limit_;  // mu F'_z |n|
};

}  // namespace groundtruth::fast
