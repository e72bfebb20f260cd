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

template <class Real, int n>
std::optional<bool> is_upright(const CountedVector<Real, n>& normal_in_wheel, double min_uprightness) {
  const auto& [x, y, z] = normal_in_wheel;
  const Sign side = sign_of(z);
  if (side == Sign::uncertain) return std::nullopt;
  if (side != Sign::negative) return false;
  return is_at_most(square(counted<Real>(min_uprightness)) * (square(x) + square(y)), square(z));
}

// What a pebble bears on a surface.
template <class Real, int n, int b>
struct Grasp {
  CountedVector<Real, n> normal_in_wheel;  // any length; upright
  Counted<Real, 0> friction;
  Counted<Real, b> brake;
};

// What a clip does: SPEC section 4, stick and cases 1 to 3 of slip.
enum class Clipping { none, onto_band_edge, onto_corner, onto_circle };

// The force in the surface's axes, each as long as it is here:
//   along  = F'_x r,      axis (-n_z, 0, n_x), of length r
//   across = F'_y r |n|,  axis (-n_x n_y, r^2, -n_y n_z), of length r |n|
//   down   = F'_z |n|,    axis -n
template <class Real, int n, int f, int b>
class ForceOnSurface {
 public:
  ForceOnSurface(const Grasp<Real, n, b>& grasp, const CountedVector<Real, f>& force)
      : grasp_(grasp),
        r_squared_(square(x()) + square(z())),
        n_squared_(r_squared_ + square(y())),
        along_(x() * force[2] - z() * force[0]),
        across_(r_squared_ * force[1] - y() * (x() * force[0] + z() * force[2])),
        down_(-dot(grasp.normal_in_wheel, force)),
        limit_(grasp.friction * down_) {}

  std::optional<Clipping> decide() const {
    const auto within_band = is_at_most(square(along_), square(grasp_.brake) * r_squared_);
    if (!within_band) return std::nullopt;
    if (!*within_band) return decide_slip();
    const auto within_disc =
        is_at_most(square(along_) * n_squared_ + square(across_), square(limit_) * r_squared_);
    if (!within_disc) return std::nullopt;
    return *within_disc ? Clipping::none : decide_slip();
  }

  // with(force in wheel coordinates), for a clipping that is not `none`. Unlike roundings make unlike types.
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
    const auto between_corners = is_at_most(square(across_), r_squared_ * corner);
    if (!between_corners) return std::nullopt;
    if (*between_corners) return Clipping::onto_band_edge;
    const auto beside_corner = is_at_most(square(grasp_.brake * across_), square(along_) * corner);
    if (!beside_corner) return std::nullopt;
    return *beside_corner ? Clipping::onto_corner : Clipping::onto_circle;
  }

  // The slips H of SPEC section 4, cases 1 to 3.
  auto onto_band_edge() const {
    const auto inverse = one() / (r_squared_ * n_squared_);
    return in_wheel(with_sign_of(along_, grasp_.brake * root(r_squared_)) * n_squared_ * inverse,
                    across_ * inverse, down_ * r_squared_ * inverse);
  }
  auto onto_corner() const {
    const auto inverse = one() / (r_squared_ * n_squared_);
    return in_wheel(with_sign_of(along_, grasp_.brake * root(r_squared_)) * n_squared_ * inverse,
                    with_sign_of(across_, root(corner_squared() * r_squared_)) * inverse,
                    down_ * r_squared_ * inverse);
  }
  auto onto_circle() const {
    const auto length = root((square(along_) * n_squared_ + square(across_)) * r_squared_);
    const auto inverse = one() / (length * n_squared_);
    const auto scale = magnitude(limit_) * inverse;
    return in_wheel(scale * along_ * n_squared_, scale * across_, down_ * length * inverse);
  }

  // s^2 |n|^2
  auto corner_squared() const { return square(limit_) - square(grasp_.brake) * n_squared_; }

  // No slip's sign of a component matters where it is uncertain: then the component is 0 (lemma slip-signs).
  template <int m, int k>
  static Counted<Real, k> with_sign_of(const Counted<Real, m>& sign, const Counted<Real, k>& x) {
    const auto approximate = static_cast<double>(sign.value);
    return approximate > 0 ? x : approximate < 0 ? -x : Counted<Real, k>{};
  }

  template <class Along, class Across, class Down>
  auto in_wheel(const Along& along, const Across& across, const Down& down) const {
    const auto component = [&](const auto& along_axis, const auto& across_axis, const auto& normal) {
      return along * along_axis + across * across_axis - down * normal;
    };
    const auto forward = component(-z(), -(x() * y()), x());
    return CountedVector<Real, decltype(forward)::roundings>{forward, across * r_squared_ - down * y(),
                                                             component(x(), -(y() * z()), z())};
  }

  using Normal = Counted<Real, n>;
  using Force = Counted<Real, f>;
  using RSquared = decltype(square(Normal()) + square(Normal()));
  using NSquared = decltype(RSquared() + square(Normal()));
  using Along = decltype(Normal() * Force() - Normal() * Force());
  using Across = decltype(RSquared() * Force() - Normal() * Along());
  using Down = decltype(dot(CountedVector<Real, n>(), CountedVector<Real, f>()));
  using Limit = decltype(Counted<Real, 0>() * Down());

  static Counted<Real, 0> one() { return counted<Real>(1); }
  const Normal& x() const { return grasp_.normal_in_wheel[0]; }
  const Normal& y() const { return grasp_.normal_in_wheel[1]; }
  const Normal& z() const { return grasp_.normal_in_wheel[2]; }

  const Grasp<Real, n, b>& grasp_;
  const RSquared r_squared_;
  const NSquared n_squared_;
  const Along along_;
  const Across across_;
  const Down down_;
  const Limit limit_;  // mu F'_z |n|
};

}  // namespace groundtruth::fast
