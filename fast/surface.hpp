#pragma once
// A surface at the wheel, and what it does to a force (SPEC section 4), in counted numbers. Not installed.
//
// Whatever takes a decision returns nothing where that is uncertain.

#include <array>
#include <type_traits>

#include <groundtruth/fast/clipping.hpp>
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

// Lemma loose-pairs: as many roundings as one by one.
template <class Real, int m, int n>
Counted<Real, m + n + 3> dot(const CountedVector<Real, m>& a, const CountedVector<Real, n>& b) {
  const Real first_two = Real::loose_sum(loose_product(a[0], b[0]), loose_product(a[1], b[1]));
  const double size = (product_of_sizes(a[0].size, b[0].size) + product_of_sizes(a[1].size, b[1].size)) +
                      product_of_sizes(a[2].size, b[2].size);
  return {Real::loose_sum(first_two, loose_product(a[2], b[2])).tidy(), size};
}

// a b - c d, likewise.
template <class Real, int m, int n>
Counted<Real, m + n + 2> determinant(const Counted<Real, m>& a, const Counted<Real, n>& b,
                                     const Counted<Real, m>& c, const Counted<Real, n>& d) {
  return {Real::loose_sum(loose_product(a, b), -loose_product(c, d)).tidy(),
          product_of_sizes(a.size, b.size) + product_of_sizes(c.size, d.size)};
}
template <class Real, int m, int n>
CountedVector<Real, m + n + 2> cross(const CountedVector<Real, m>& a, const CountedVector<Real, n>& b) {
  return {determinant(a[1], b[2], a[2], b[1]), determinant(a[2], b[0], a[0], b[2]),
          determinant(a[0], b[1], a[1], b[0])};
}

// a <= b?
template <class Real, int m, int n>
std::optional<bool> is_at_most(const Counted<Real, m>& a, const Counted<Real, n>& b) {
  const Sign sign = sign_of(b - a);
  if (sign == Sign::uncertain) return std::nullopt;
  return sign != Sign::negative;
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
      : grasp_(grasp), forward_(forward), force_(force) {}

  // Each is computed where it is asked for: no clipping needs them all.
  auto n_squared() const { return dot(grasp_.normal, grasp_.normal); }
  auto down() const { return -dot(grasp_.normal, force_); }

  std::optional<Clipping> decide() const {
    const auto within_band = is_at_most(square(along()), square(grasp_.brake) * g_squared());
    if (!within_band) return std::nullopt;
    if (!*within_band) return decide_slip();
    const auto within_disc = is_at_most(turning_squared(), square(limit()));
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
    const auto between_corners = is_at_most(square(across()), g_squared() * corner);
    if (!between_corners) return std::nullopt;
    if (*between_corners) return Clipping::onto_band_edge;
    const auto beside_corner = is_at_most(square(grasp_.brake * across()), square(along()) * corner);
    if (!beside_corner) return std::nullopt;
    return *beside_corner ? Clipping::onto_corner : Clipping::onto_circle;
  }

  // The slips of SPEC section 4, cases 1 to 3. Without a brake components can be 0, which a difference of
  // rounded numbers never shows.
  auto onto_band_edge() const {
    using Corrected = decltype(corrected_to_band_edge());
    using Projected = decltype(projected_on_line());
    using Component =
        Counted<Real, std::max(Corrected::value_type::roundings, Projected::value_type::roundings)>;
    const auto component_of = [](const auto& v) {
      return std::array<Component, 3>{Component(v[0]), Component(v[1]), Component(v[2])};
    };
    return grasp_.brake.size == 0 ? component_of(projected_on_line())
                                  : component_of(corrected_to_band_edge());
  }
  auto corrected_to_band_edge() const {
    const auto forward_squared = g_squared();
    const auto ahead = along();
    const auto missing =
        (with_sign_of(ahead, grasp_.brake * root(forward_squared)) - ahead) / forward_squared;
    return vector_of([&](std::size_t k) { return force_[k] + missing * forward_[k]; });
  }
  auto projected_on_line() const {
    const auto length_squared = n_squared();
    const auto aside = across() / (g_squared() * length_squared);
    const auto pressed = down() / length_squared;
    const auto across_axis = cross(forward_, grasp_.normal);
    return vector_of([&](std::size_t k) { return aside * across_axis[k] - pressed * grasp_.normal[k]; });
  }
  auto onto_corner() const {
    const auto inverse_length = one() / root(g_squared());
    const auto inverse = one() / n_squared();
    const auto ahead = with_sign_of(along(), grasp_.brake * inverse_length);
    const auto aside = with_sign_of(across(), root(corner_squared()) * inverse_length * inverse);
    const auto pressed = down() * inverse;
    const auto across_axis = cross(forward_, grasp_.normal);
    return vector_of([&](std::size_t k) {
      return (ahead * forward_[k] + aside * across_axis[k]) - pressed * grasp_.normal[k];
    });
  }
  // By force - pressed n = turning x n / |n|^2: along a normal that is an axis nothing is rounded.
  auto onto_circle() const {
    const auto length_squared = n_squared();
    const auto pressed = down() / length_squared;
    const auto aside = cross(turning_at_rim(), grasp_.normal);
    return vector_of([&](std::size_t k) { return aside[k] / length_squared - pressed * grasp_.normal[k]; });
  }
  // As long as the disc allows. Along an axis that is known without a root.
  auto turning_at_rim() const {
    const auto v = turning();
    const auto rim = magnitude(limit());
    const auto part = rim / root(turning_squared());
    return vector_of([&](std::size_t k) {
      const bool is_alone = v[(k + 1) % 3].size == 0 && v[(k + 2) % 3].size == 0;
      const auto scaled = part * v[k];
      return is_alone ? std::remove_const_t<decltype(scaled)>(with_sign_of(v[k], rim)) : scaled;
    });
  }

  template <class Axis>
  static auto vector_of(const Axis& axis) {
    const auto first = axis(0);
    return CountedVector<Real, decltype(first)::roundings>{first, axis(1), axis(2)};
  }

  auto g_squared() const { return dot(forward_, forward_); }
  auto along() const { return dot(forward_, force_); }
  auto turning() const { return cross(grasp_.normal, force_); }
  auto across() const { return dot(forward_, turning()); }
  auto limit() const { return grasp_.friction * down(); }  // mu F'_z |n|
  auto turning_squared() const {
    const auto v = turning();
    return square(v[0]) + square(v[1]) + square(v[2]);
  }
  // s^2 |n|^2
  auto corner_squared() const { return square(limit()) - square(grasp_.brake) * n_squared(); }

  // No slip's sign of a component matters where it is uncertain: then the component is 0 (lemma slip-signs).
  template <int m, int k>
  static Counted<Real, k> with_sign_of(const Counted<Real, m>& sign, const Counted<Real, k>& x) {
    const auto approximate = static_cast<double>(sign.value);
    return approximate > 0 ? x : approximate < 0 ? -x : Counted<Real, k>{};
  }

  static Counted<Real, 0> one() { return counted<Real>(1); }

  const Grasp<Real, b>& grasp_;
  const CountedVector<Real, g>& forward_;
  const CountedVector<Real, f>& force_;
};

}  // namespace groundtruth::fast
