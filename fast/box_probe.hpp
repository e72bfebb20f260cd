#pragma once
// A range against boxes in floats. Not installed.

#include <algorithm>
#include <cmath>

#include <groundtruth/fast/cell_kernels.hpp>
#include <groundtruth/fast/range_ends.hpp>

namespace groundtruth::fast {

// Lemma box-slabs (proofs-notes/rounding.md). Per axis the near side of a box is met at (near - near_origin)
// * inverse, the far side at (far - far_origin) * inverse. The origins are moved apart by `pad`, which
// exceeds the rounding of the ends, of the origins themselves, and the whole way along an axis of which the
// inverse is cut off; differences keep their sign, so that only far positions, which are > 0 where the box is
// met, need to be stretched for the relative errors that are left.
class BoxProbe {
 public:
  explicit BoxProbe(const RangeEnds& ends) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double from = ends.first[axis], way = ends.last[axis] - from + 0.0;  // no -0
      const double pad = 0x1p-20 * (std::abs(from) + std::abs(way)) + 8 * ends.coordinate_error + 1e-20;
      constexpr double shortest_way = 1e-30;
      const double long_enough = std::copysign(std::max(std::abs(way), shortest_way), way);
      const double pad_along = std::copysign(pad, way);
      way_.inverse[axis] = static_cast<float>(1 / long_enough);
      way_.near_origin[axis] = static_cast<float>(from + pad_along);
      way_.far_origin[axis] = static_cast<float>(from - pad_along);
      way_.is_ascending[axis] = way >= 0;
    }
  }

  const BoxWay& way() const { return way_; }

  // The children of the node that may be met no later than `upper`, which is at most 1, as bits, and where
  // they may be met first.
  unsigned meet(const CellKernels& kernels, const BoxNode& node, double upper,
                float (&nearest)[BoxNode::width]) const {
    return kernels.meet_boxes(node, way_, static_cast<float>(upper * (1 + 0x1p-20)), nearest);
  }

 private:
  BoxWay way_;
};

}  // namespace groundtruth::fast
