#pragma once
// The decisions of a clip in doubles, under one bound for the ask. Not installed.
//
// Whatever takes a decision returns nothing where that is uncertain, or something overflows.

#include <optional>

#include <groundtruth/fast/clipping.hpp>
#include <groundtruth/fast/pairs.hpp>
#include <groundtruth/fast/support.hpp>

namespace groundtruth::fast {

// Sizes with which no product here underflows by what a bound would notice.
inline bool is_in_window(double size) { return size >= 0x1p-100 && size <= 0x1p100; }
inline bool is_zero_or_in_window(double size) { return size == 0 || is_in_window(size); }

// a <= b, of numbers whose sum of errors is at most 2^-44 (size of a + size of b + more)? Lemma
// decisions-in-doubles, proofs-notes/rounding-of-forces.md, section 8.
inline std::optional<bool> is_at_most(double a, double b, double sizes) {
  const double difference = b - a, margin = 0x1p-44 * sizes;
  if (difference > margin) return true;
  if (difference < -margin) return false;
  return std::nullopt;
}

// Of a normal `depth` along the wheel's z axis, downward; both squared sizes are within 2^-50, the depth
// within 2^-50 of their root.
inline std::optional<bool> is_upright(double depth, double length_squared, double min_uprightness) {
  const double t_squared = min_uprightness * min_uprightness, depth_squared = depth * depth;
  if (!(depth_squared > 0x1p-90 * length_squared)) return std::nullopt;
  if (depth > 0) return false;
  const double least = t_squared * length_squared, got = (1 + t_squared) * depth_squared;
  return is_at_most(least, got, (least + got) + (1 + t_squared) * length_squared);
}

// Vectors may be in any axes, the same ones for all of a surface: those of ForceOnSurface (surface.hpp).
struct ForceAsk {
  Vector normal;
  Vector forward;     // within 2^-47 of its length
  Vector force;       // within 2^-52 force_size
  double force_size;  // >= |force|, exact and here
  double friction;
  double brake;
};

class SurfaceInDoubles {
 public:
  explicit SurfaceInDoubles(const ForceAsk& ask)
      : ask_(ask),
        n_squared_(dot_in_doubles(ask.normal, ask.normal)),
        g_squared_(dot_in_doubles(ask.forward, ask.forward)),
        down_(-dot_in_doubles(ask.normal, ask.force)),
        along_(dot_in_doubles(ask.forward, ask.force)),
        turning_(cross_in_doubles(ask.normal, ask.force)),
        force_squared_(ask.force_size * ask.force_size),
        friction_squared_(ask.friction * ask.friction),
        brake_squared_(ask.brake * ask.brake) {}

  // With `forward` scaled by this: by the wheel's |q|^2 in a step.
  bool is_usable(double scale_squared) const {
    return is_in_window(n_squared_) && is_in_window(ask_.force_size) && is_zero_or_in_window(ask_.friction) &&
           is_zero_or_in_window(ask_.brake) && g_squared_ > 0x1p-4 * (n_squared_ * scale_squared);
  }

  double n_squared() const { return n_squared_; }
  double down() const { return down_; }

  std::optional<bool> is_pressed() const {
    if (!(down_ * down_ > 0x1p-90 * (n_squared_ * force_squared_))) return std::nullopt;
    return down_ > 0;
  }

  std::optional<bool> holds(double maximum_force) const {
    const double got = down_ * down_, limit = maximum_force * maximum_force * n_squared_;
    return is_at_most(got, limit, got + limit + n_squared_ * force_squared_);
  }

  // `support` gives the SurfaceSupport of what the ask stands for; it is asked only where that matters.
  template <class GivesSupport>
  std::optional<Clipping> decide(const GivesSupport& support) const {
    const auto within_band = is_within_band(support);
    if (!within_band) return std::nullopt;
    if (!*within_band) return decide_slip();
    const auto within_disc = is_within_disc(support);
    if (!within_disc) return std::nullopt;
    return *within_disc ? Clipping::none : decide_slip();
  }

  // Of how much the corner of band and disc moves with the disc.
  double corner_condition() const {
    return std::sqrt(limit_squared() / (limit_squared() - brake_squared_ * n_squared_));
  }

 private:
  // Without a brake, or friction, what is asked is whether a number is 0.
  template <class GivesSupport>
  std::optional<bool> is_within_band(const GivesSupport& support) const {
    const double along_squared = along_ * along_, floor = g_squared_ * force_squared_;
    if (ask_.brake == 0) return is_zero(along_squared, floor, [&] { return support().may_pull_along(); });
    const double band = brake_squared_ * g_squared_;
    return is_at_most(along_squared, band, (along_squared + band) + floor);
  }
  template <class GivesSupport>
  std::optional<bool> is_within_disc(const GivesSupport& support) const {
    const double turning_squared = dot_in_doubles(turning_, turning_), floor = n_squared_ * force_squared_;
    if (ask_.friction == 0) return is_zero(turning_squared, floor, [&] { return support().may_turn(); });
    const double limit = limit_squared();
    return is_at_most(turning_squared, limit, (turning_squared + limit) + disc_floor());
  }
  template <class MayDiffer>
  static std::optional<bool> is_zero(double squared, double floor, const MayDiffer& may_differ) {
    if (squared > 0x1p-90 * floor) return false;
    return may_differ() ? std::nullopt : std::optional(true);
  }

  std::optional<Clipping> decide_slip() const {
    if (ask_.friction == 0) return Clipping::onto_circle;
    const double limit = limit_squared(), band = brake_squared_ * n_squared_, corner = limit - band;
    const auto no_corner = is_at_most(limit, band, (limit + band) + disc_floor());
    if (!no_corner) return std::nullopt;
    if (*no_corner) return Clipping::onto_circle;
    const double across = dot_in_doubles(ask_.forward, turning_), across_squared = across * across;
    const auto between_corners =
        is_at_most(across_squared, g_squared_ * corner,
                   (across_squared + g_squared_ * (limit + band)) + g_squared_ * disc_floor());
    if (!between_corners) return std::nullopt;
    if (*between_corners) return Clipping::onto_band_edge;
    if (ask_.brake == 0) return Clipping::onto_corner;
    const double along_squared = along_ * along_, over = brake_squared_ * across_squared;
    const auto beside_corner =
        is_at_most(over, along_squared * corner,
                   (over + along_squared * (limit + band)) +
                       (g_squared_ * force_squared_) * (4 * (limit + band) + 4 * disc_floor()));
    if (!beside_corner) return std::nullopt;
    return *beside_corner ? Clipping::onto_corner : Clipping::onto_circle;
  }

  double limit_squared() const { return friction_squared_ * (down_ * down_); }
  double disc_floor() const { return (1 + friction_squared_) * (n_squared_ * force_squared_); }

  const ForceAsk& ask_;
  const double n_squared_, g_squared_, down_, along_;
  const Vector turning_;
  const double force_squared_, friction_squared_, brake_squared_;
};

}  // namespace groundtruth::fast
