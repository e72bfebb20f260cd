#pragma once
// A range against boxes in floats. Not installed.

#include <algorithm>
#include <cmath>

#include <groundtruth/fast/hierarchy.hpp>
#include <groundtruth/fast/lanes.hpp>
#include <groundtruth/fast/range_ends.hpp>

namespace groundtruth::fast {

// Beyond this, floats are too coarse to cut anything off.
inline constexpr double greatest_box_coordinate = 0x1p60;

// Lemma box-slabs (proofs-notes/rounding.md). Per axis the near side of a box is met at (near - near_origin)
// * inverse, the far side at (far - far_origin) * inverse. The origins are moved apart by `pad`, which
// exceeds the rounding of the ends, of the origins themselves, and the whole way along an axis of which the
// inverse is cut off; differences keep their sign, so that only far positions, which are > 0 where the box is
// met, need to be stretched for the relative errors that are left.
class BoxProbe {
 public:
  explicit BoxProbe(const RangeEnds& ends) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double from = ends.first[axis], way = ends.last[axis] - from;
      const double pad = 0x1p-20 * (std::abs(from) + std::abs(way)) + 8 * ends.coordinate_error + 1e-20;
      const bool is_ascending = way >= 0;
      constexpr double shortest_way = 1e-30;
      const double inverse =
          std::abs(way) > shortest_way ? 1 / way : (is_ascending ? 1 / shortest_way : -1 / shortest_way);
      inverse_[axis] = static_cast<float>(inverse);
      near_origin_[axis] = static_cast<float>(is_ascending ? from + pad : from - pad);
      far_origin_[axis] = static_cast<float>(is_ascending ? from - pad : from + pad);
      is_ascending_[axis] = is_ascending;
    }
  }

  // Positions at which the children of the node may be met first; greater than `upper`, which is at most 1,
  // where they are not before.
  void meet(const BoxNode& node, double upper, float (&nearest)[BoxNode::width]) const {
    FloatLanes near = FloatLanes::all(0), far = FloatLanes::all(static_cast<float>(upper * (1 + 0x1p-20)));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const FloatLanes near_side = FloatLanes::load(is_ascending_[axis] ? node.low[axis] : node.high[axis]);
      const FloatLanes far_side = FloatLanes::load(is_ascending_[axis] ? node.high[axis] : node.low[axis]);
      const FloatLanes inverse = FloatLanes::all(inverse_[axis]);
      const FloatLanes stretched = FloatLanes::all(inverse_[axis] * (1 + 0x1p-20F));
      near = greater((near_side - FloatLanes::all(near_origin_[axis])) * inverse, near);
      far = lesser((far_side - FloatLanes::all(far_origin_[axis])) * stretched, far);
    }
    choose(near <= far, near, FloatLanes::all(2)).store(nearest);
  }

 private:
  float near_origin_[3];
  float far_origin_[3];
  float inverse_[3];
  bool is_ascending_[3];
};

}  // namespace groundtruth::fast
