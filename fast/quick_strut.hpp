#pragma once
// Where a wheel's strut meets the ground, in double-double under one bound for the ask. Not installed.

#include <limits>

#include <groundtruth/fast/quick_load.hpp>
#include <groundtruth/fast/range_ends.hpp>

namespace groundtruth::fast {

// From the frame to where a strut passes, but for a part along it: within 2^-83 size.
template <class Pair>
struct QuickOffset {
  Vector3<Pair> from_frame{};
  double size = 0;  // >= its length; infinite where no bound holds
};

template <class Pair>
struct QuickLanding {
  static constexpr std::size_t no_axis = 3;

  Vector3<Pair> from_frame_in_world;  // its place less the frame's, within `error`; loose
  double error;                       // not finite where the plane is so steep that no bound holds
  std::size_t level_axis = no_axis;   // to which the plane is square: there every point has this coordinate
  double level = 0;
};

// Lemma strut-in-pairs, proofs-notes/rounding-of-forces.md, section 11.
template <class Pair>
class QuickStrut {
 public:
  QuickStrut(const StepAsk& ask, const QuickAxes<Pair>& axes, const QuickOffset<Pair>& offset)
      : ask_(ask), axes_(axes), offset_(offset) {}

  RangeEnds ends() const {
    const Wheel& wheel = ask_.wheel;
    const Vector offset = highs_of(offset_.from_frame), down = highs_of(axes_.down());
    const double inverse = 1 / axes_.norm_squared().high, depth = dot_in_doubles(down, offset) * inverse;
    const double first = (wheel.z_min - depth) * inverse, last = (wheel.z_max - depth) * inverse;
    RangeEnds ends;
    double farthest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double b = ask_.frame.position_in_world[k];
      ends.first[k] = b + (offset[k] + first * down[k]);
      ends.last[k] = b + (offset[k] + last * down[k]);
      farthest = std::max(farthest, std::abs(b));
    }
    ends.coordinate_error = 0x1p-51 * farthest +
                            0x1p-47 * (offset_.size + (std::abs(wheel.z_min) + std::abs(wheel.z_max))) +
                            0x1p-1000;
    return ends;
  }

  QuickLanding<Pair> landing_on(const HalfSpace& plane) const {
    const Vector& b = ask_.frame.position_in_world;
    const Vector& n = plane.normal;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (std::abs(n[axis]) != 1 || n[(axis + 1) % 3] != 0 || n[(axis + 2) % 3] != 0) continue;
      const double level = n[axis] * plane.offset + 0.0;
      const Pair height = Pair::sum(level, -b[axis]);
      QuickLanding<Pair> landing = landing_at(Pair::loose_sum(height, -offset_.from_frame[axis]),
                                              axes_.down()[axis], std::abs(height.high), 1);
      landing.level_axis = axis;
      landing.level = level;
      return landing;
    }
    const double n_size = sum_of_magnitudes(n);
    const Pair height =
        Pair::loose_sum(Pair::loose_sum(plane.offset, -dot<Pair>(n, b)), -dot<Pair>(n, offset_.from_frame));
    return landing_at(height, dot<Pair>(n, axes_.down()),
                      std::abs(plane.offset) / n_size + sum_of_magnitudes(b), n_size);
  }

 private:
  QuickLanding<Pair> landing_at(const Pair& height, const Pair& slope, double plane_size,
                                double n_size) const {
    const double inverse = 1 / slope.high;
    const double steepness = std::abs(n_size * axes_.norm_squared().high * inverse);
    const double size = plane_size + offset_.size;
    const bool is_bound = steepness < 0x1p12 && size > 0x1p-200;
    const Pair way = quotient(height, slope, inverse);
    const auto axis = [&](std::size_t k) {
      return Pair::loose_sum(offset_.from_frame[k], product_of<Pair>(way, axes_.down()[k]));
    };
    return {{axis(0), axis(1), axis(2)},
            is_bound ? steepness * (0x1p-81 * offset_.size + 0x1p-94 * (steepness * plane_size))
                     : std::numeric_limits<double>::infinity()};
  }

  const StepAsk& ask_;
  const QuickAxes<Pair>& axes_;
  const QuickOffset<Pair>& offset_;
};

}  // namespace groundtruth::fast
