#include <groundtruth/fast/clip.hpp>

#include <algorithm>

#include <groundtruth/fast/surface.hpp>

namespace groundtruth::fast {

namespace {

// The force in the surface's axes, each times the length of the axis as it stands here:
//   along  = F'_x r,          axis (-n_z, 0, n_x), of length r
//   across = F'_y r |n|,      axis (-n_x n_y, r^2, -n_y n_z), of length r |n|
//   down   = F'_z |n|,        axis -n
template <class Number>
class ForceOnSurface {
 public:
  ForceOnSurface(const Grasp<Number>& grasp, const Vector3<Number>& force)
      : grasp_(grasp),
        force_(force),
        r_squared_(square(n().x()) + square(n().z())),
        n_squared_(r_squared_ + square(n().y())),
        along_axis_(-n().z(), 0, n().x()),
        across_axis_(-n().x() * n().y(), r_squared_, -n().y() * n().z()),
        along_(along_axis_.dot(force)),
        across_(across_axis_.dot(force)),
        down_(-n().dot(force)),
        disc_(square(grasp.friction * down_)),
        band_(square(grasp.brake) * n_squared_),
        corner_(disc_ - band_) {}

  ClippedForce<Number> clipped() const {
    if (is_within_border()) return {Grip::stick, force_};
    if (band_ < disc_ && is_between_corners()) return {Grip::slip, onto_band_edge()};
    if (band_ < disc_ && is_beside_corner()) return {Grip::slip, onto_corner()};
    return {Grip::slip, onto_circle()};
  }

 private:
  static Number square(Number x) { return x * x; }
  static Number with_sign_of(Number sign, Number magnitude) {
    return sign > 0 ? magnitude : sign < 0 ? -magnitude : Number(0);
  }
  const Vector3<Number>& n() const { return grasp_.normal_in_wheel; }

  // With mu^2 N^2 |n|^2 = disc_ and B^2 |n|^2 = band_.
  bool is_within_border() const {
    return square(along_) <= square(grasp_.brake) * r_squared_ &&
           square(along_) * n_squared_ + square(across_) <= disc_ * r_squared_;
  }
  bool is_between_corners() const { return square(across_) <= r_squared_ * corner_; }
  bool is_beside_corner() const { return square(grasp_.brake) * square(across_) <= square(along_) * corner_; }

  // The slips H of SPEC section 4, cases 1 to 3.
  Vector3<Number> onto_band_edge() const {
    return in_wheel(band_edge(), across_ / (r_squared_ * n_squared_));
  }
  Vector3<Number> onto_corner() const {
    return in_wheel(band_edge(), with_sign_of(across_, std::sqrt(corner_ / r_squared_) / n_squared_));
  }
  Vector3<Number> onto_circle() const {
    const Number length = std::sqrt((square(along_) * n_squared_ + square(across_)) * r_squared_);
    const Number scale = grasp_.friction * std::abs(down_) / length;
    return in_wheel(scale * along_, scale * across_ / n_squared_);
  }
  Number band_edge() const { return with_sign_of(along_, grasp_.brake / std::sqrt(r_squared_)); }

  Vector3<Number> in_wheel(Number along, Number across) const {
    return along * along_axis_ + across * across_axis_ - (down_ / n_squared_) * n();
  }

  const Grasp<Number>& grasp_;
  const Vector3<Number>& force_;
  const Number r_squared_;
  const Number n_squared_;
  const Vector3<Number> along_axis_;
  const Vector3<Number> across_axis_;
  const Number along_;
  const Number across_;
  const Number down_;
  const Number disc_;    // mu^2 N^2 |n|^2
  const Number band_;    // B^2 |n|^2
  const Number corner_;  // s^2 |n|^2
};

int exponent_of(Wide magnitude) { return magnitude == 0 ? 0 : std::ilogb(magnitude); }

Vector3<Wide> scaled(const Vector3<Wide>& v, int exponent) {
  return v.unaryExpr([exponent](Wide x) { return std::ldexp(x, exponent); });
}

}  // namespace

ClippedForce<Wide> clip_force(const Grasp<Wide>& grasp, const Vector3<Wide>& force_in_wheel) {
  // Powers of two change no decision: the normal's length does not matter, force and brake scale together.
  const int size = exponent_of(std::max(force_in_wheel.cwiseAbs().maxCoeff(), grasp.brake));
  const int normal_size = exponent_of(grasp.normal_in_wheel.cwiseAbs().maxCoeff());
  const Vector3<Wide> force = scaled(force_in_wheel, -size);
  const Grasp<Wide> scaled_grasp{scaled(grasp.normal_in_wheel, -normal_size), grasp.friction,
                                 std::ldexp(grasp.brake, -size)};
  const ClippedForce<Wide> clipped = ForceOnSurface<Wide>(scaled_grasp, force).clipped();
  return {clipped.grip, scaled(clipped.force_in_wheel, size)};
}

ClippedForce<double> clip_force(const Grasp<double>& grasp, const Vector3<double>& force_in_wheel) {
  const auto is_ordinary = [](double x) { return ordinary_clip_size.contains(x); };
  if (is_ordinary(grasp.friction) && is_ordinary(grasp.brake) &&
      ordinary_clip_size.contains(rounded(grasp.normal_in_wheel)) &&
      ordinary_clip_size.contains(rounded(force_in_wheel)))
    return ForceOnSurface<double>(grasp, force_in_wheel).clipped();
  const ClippedForce<Wide> clipped =
      clip_force(Grasp<Wide>{grasp.normal_in_wheel.cast<Wide>(), grasp.friction, grasp.brake},
                 force_in_wheel.cast<Wide>());
  return {clipped.grip, clipped.force_in_wheel.cast<double>()};
}

ClipAnswer clip(const ClipAsk& ask) {
  if (!is_upright<Wide>(as<Wide>(ask.normal_in_wheel), ask.min_uprightness)) return TooSteep{};
  const Grasp<double> grasp{as<double>(ask.normal_in_wheel), ask.friction, ask.brake};
  const ClippedForce<double> clipped = clip_force(grasp, as<double>(ask.force_in_wheel));
  const Vector force = rounded(clipped.force_in_wheel);
  if (auto refusal = refuse_unless_finite(force, "force")) return *refusal;
  return Clipped{clipped.grip, force};
}

}  // namespace groundtruth::fast
