#pragma once
// A range against a hierarchy's boxes, and the order in which they are looked at. Not installed.
//
// As cell_kernels_body.hpp: nothing here may be shared between sets of instructions.

#include <groundtruth/fast/box_way.hpp>
#include <groundtruth/fast/hierarchy.hpp>

namespace groundtruth::fast {

// Lemma box-slabs (box_probe.hpp).
template <class FloatLanes>
class BoxMeeter {
 public:
  explicit BoxMeeter(const BoxWay& way) {
    for (int axis = 0; axis < 3; ++axis) {
      Axis& at = axes_[axis];
      at.near_origin = FloatLanes::all(way.near_origin[axis]);
      at.far_origin = FloatLanes::all(way.far_origin[axis]);
      at.inverse = FloatLanes::all(way.inverse[axis]);
      at.stretched = FloatLanes::all(way.inverse[axis] * (1 + 0x1p-20F));
      at.near_sides = way.is_ascending[axis] ? &BoxNode::low : &BoxNode::high;
      at.far_sides = way.is_ascending[axis] ? &BoxNode::high : &BoxNode::low;
    }
  }

  struct Met {
    FloatLanes nearest;
    unsigned children;  // those that are met, as bits
  };

  [[gnu::always_inline]] inline Met meet(const BoxNode& node, float upper) const {
    FloatLanes near = FloatLanes::all(0), far = FloatLanes::all(upper);
    for (int axis = 0; axis < 3; ++axis) {
      const Axis& at = axes_[axis];
      const FloatLanes near_side = FloatLanes::load((node.*at.near_sides)[axis]);
      const FloatLanes far_side = FloatLanes::load((node.*at.far_sides)[axis]);
      near = greater((near_side - at.near_origin) * at.inverse, near);
      far = lesser((far_side - at.far_origin) * at.stretched, far);
    }
    return {near, (near <= far).bits()};
  }

 private:
  using Sides = float (BoxNode::*)[3][BoxNode::width];
  struct Axis {
    FloatLanes near_origin, far_origin, inverse, stretched;
    Sides near_sides, far_sides;
  };

  Axis axes_[3];
};

template <class FloatLanes>
unsigned meet_eight_boxes(const BoxNode& node, const BoxWay& way, float upper, float* nearest) {
  const auto met = BoxMeeter<FloatLanes>(way).meet(node, upper);
  met.nearest.store(nearest);
  return met.children;
}

// What is to be looked at, nearest last: the bits of a float >= 0 above the number of a child, in the order
// of the floats.
template <class FloatLanes>
class OpenChildren {
 public:
  // `fetch` asks the memory for a child. Each goes to its place by counting those before it: which of two is
  // nearer nobody can foretell.
  template <class Fetch>
  [[gnu::always_inline]] inline void push(const typename BoxMeeter<FloatLanes>::Met& met,
                                          const std::uint32_t* children, const Fetch& fetch) {
    float nearest[BoxNode::width];
    met.nearest.store(nearest);
    for (unsigned left = met.children; left != 0; left &= left - 1) {
      const int child = __builtin_ctz(left);
      const FloatLanes own = FloatLanes::all(nearest[child]);
      const unsigned further = (met.nearest > own).bits() & met.children;
      const unsigned as_near_and_later = (met.nearest >= own).bits() & left & (left - 1);
      std::uint32_t bits;
      __builtin_memcpy(&bits, nearest + child, sizeof bits);
      end_[__builtin_popcount(further | as_near_and_later)] = std::uint64_t{bits} << 32 | children[child];
      fetch(children[child]);
    }
    end_ += __builtin_popcount(met.children);
  }
  // The next one's number, if there is one that may be met no later than `upper`.
  [[gnu::always_inline]] inline bool pop(double upper, std::uint32_t& child) {
    while (end_ != open_) {
      const std::uint64_t one = *--end_;
      const auto bits = static_cast<std::uint32_t>(one >> 32);
      float nearest;
      __builtin_memcpy(&nearest, &bits, sizeof nearest);
      child = static_cast<std::uint32_t>(one);
      if (double{nearest} <= upper) return true;
    }
    return false;
  }

 private:
  // Each level leaves all but one child of a node.
  static constexpr std::size_t most = (BoxNode::width - 1) * (BoxNode::most_depth + 1) + 1;

  std::uint64_t open_[most];
  std::uint64_t* end_ = open_;
};

}  // namespace groundtruth::fast
