#pragma once
// A segment, and where it crosses planes. Not installed.
//
// Everything fast decides about a segment it decides by comparing crossings, each of them rounded once and
// for all: whatever the rounding, the decisions of one ask never contradict each other.

#include <groundtruth/fast/number.hpp>
#include <groundtruth/problem/shape.hpp>

namespace groundtruth::fast {

// Within these, no product that an entry ask forms in doubles overflows.
inline constexpr Magnitudes ordinary_size{0x1p-150, 0x1p150};

template <class Number>
struct Range {
  Number first;
  Number last;
};

enum class Side { inside, on, outside };

// Delta along the segment is value + lambda * slope. In doubles each is off by no more than a few units in
// the last place of its largest term; unproved here.
template <class Number>
struct Approach {
  Number value;
  Number slope;

  bool enters() const { return slope < 0; }
  bool leaves() const { return slope > 0; }

  // Requires slope != 0.
  Number crossing() const { return -value / slope; }

  Side side_at(Number lambda) const {
    if (slope == 0) return value < 0 ? Side::inside : value > 0 ? Side::outside : Side::on;
    const Number crossed = crossing();
    if (lambda == crossed) return Side::on;
    return (lambda > crossed) == enters() ? Side::inside : Side::outside;
  }
};

template <class Number>
class Segment {
 public:
  Segment(const Vector3<Number>& from, const Vector3<Number>& to) {
    for (int axis = 0; axis < 3; ++axis) start_and_direction_[axis] << from[axis], to[axis] - from[axis];
  }

  Approach<Number> approach(const HalfSpace& leaf) const {
    const Pair sum = Number(leaf.normal[0]) * start_and_direction_[0] +
                     Number(leaf.normal[1]) * start_and_direction_[1] +
                     Number(leaf.normal[2]) * start_and_direction_[2];
    return {sum[0] - Number(leaf.offset), sum[1]};
  }

 private:
  using Pair = Eigen::Array<Number, 2, 1>;
  Pair start_and_direction_[3];  // by axis
};

}  // namespace groundtruth::fast
