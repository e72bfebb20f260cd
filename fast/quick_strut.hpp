#pragma once
// Where a wheel's strut meets the ground, in double-double under one bound for the ask. Not installed.

#include <limits>

#include <groundtruth/fast/quick_load.hpp>
#include <groundtruth/fast/range_ends.hpp>

namespace groundtruth::fast {

// From the frame to where a strut passes, but for a part along it: within 2^-83 size.
template <class Pair>
struct QuickOffset {
  Pairs3<Pair> from_frame{};
  double size = 0;  // >= its length; infinite where no bound holds
};

template <class Pair>
struct QuickLanding {
  static constexpr std::size_t no_axis = 3;

  Pairs3<Pair> from_frame_in_world;  // its place less the frame's, within `error`; loose
  double error;                      // not finite where the plane is so steep that no bound holds
  std::size_t level_axis = no_axis;  // to which the plane is square: there every point has this coordinate
  double level = 0;

  unsigned level_bit() const { return level_axis == no_axis ? 0 : 1U << level_axis; }
};

// Lemma strut-in-pairs, proofs-notes/rounding-of-forces.md, section 11.
template <class Pair>
class QuickStrut {
 public:
  using Pairs = Pairs3<Pair>;
  using Doubles = Doubles3<Pair>;

  QuickStrut(const StepAsk& ask, const QuickAxes<Pair>& axes, const QuickOffset<Pair>& offset)
      : ask_(ask), axes_(axes), offset_(offset) {}

  RangeEnds ends() const {
    const Wheel& wheel = ask_.wheel;
    const Doubles offset = offset_.from_frame.high, down = axes_.down().high,
                  frame(ask_.frame.position_in_world);
    const double inverse = 1 / axes_.norm_squared().high;
    const double depth = dot_in_doubles(Vector(down), Vector(offset)) * inverse;
    const double first = (wheel.z_min - depth) * inverse, last = (wheel.z_max - depth) * inverse;
    RangeEnds ends;
    ends.first = Vector(frame + (offset + first * down));
    ends.last = Vector(frame + (offset + last * down));
    double farthest = 0;
    for (const double b : ask_.frame.position_in_world) farthest = std::max(farthest, std::abs(b));
    ends.coordinate_error = 0x1p-51 * farthest +
                            0x1p-47 * (offset_.size + (std::abs(wheel.z_min) + std::abs(wheel.z_max))) +
                            0x1p-1000;
    return ends;
  }

  QuickLanding<Pair> landing_on(const HalfSpace& plane) const {
    const Vector& b = ask_.frame.position_in_world;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Vector& n = plane.normal;
      if (std::abs(n[axis]) != 1 || n[(axis + 1) % 3] != 0 || n[(axis + 2) % 3] != 0) continue;
      const double level = n[axis] * plane.offset + 0.0;
      const Pair height = Pair::sum(level, -b[axis]);
      QuickLanding<Pair> landing =
          landing_at(Pair::loose_sum(height, -component<Pair>(offset_.from_frame, axis)),
                     component<Pair>(axes_.down(), axis), std::abs(height.high), 1);
      landing.level_axis = axis;
      landing.level = level;
      return landing;
    }
    const double n_size = sum_of_magnitudes(plane.normal);
    const Doubles n(plane.normal);
    const Pair height = Pair::loose_sum(Pair::loose_sum(plane.offset, -dot<Pair>(n, Doubles(b))),
                                        -dot<Pair>(n, offset_.from_frame));
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
    return {Pairs::loose_sum(offset_.from_frame, product_of<Pairs>(way, axes_.down())),
            is_bound ? steepness * (0x1p-81 * offset_.size + 0x1p-94 * (steepness * plane_size))
                     : std::numeric_limits<double>::infinity()};
  }

  const StepAsk& ask_;
  const QuickAxes<Pair>& axes_;
  const QuickOffset<Pair>& offset_;
};

}  // namespace groundtruth::fast
