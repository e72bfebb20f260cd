#pragma once
// Where the vectors of a clip or a step are exactly 0: a bound for the whole ask never shows that. Not
// installed.

#include <cstddef>
#include <cstdint>

#include <groundtruth/fast/clipping.hpp>
#include <groundtruth/fast/lanes.hpp>
#include <groundtruth/problem/vector.hpp>

namespace groundtruth::fast {

// The axes along which a vector may differ from 0; along every other it is 0, exactly (lemma exact-zeros,
// proofs-notes/rounding-of-forces.md, section 12).
class Support {
 public:
  static constexpr unsigned all_axes = 7;

  constexpr Support() = default;  // of a vector that is 0
  constexpr Support(bool x, bool y, bool z) : axes_((x ? 1U : 0U) | (y ? 2U : 0U) | (z ? 4U : 0U)) {}
  explicit Support(const Vector& v) : Support(of_difference(v, {})) {}
  static Support of_difference(const Vector& a, const Vector& b) {
    const unsigned first_two = TwoDoubles::bits(V2d{a[0], a[1]} != V2d{b[0], b[1]});
    return Support(first_two | (a[2] != b[2] ? 4U : 0U));
  }

  bool has(std::size_t axis) const { return (axes_ >> axis & 1U) != 0; }
  bool is_empty() const { return axes_ == 0; }

  // Of a sum.
  friend Support operator|(Support a, Support b) { return Support(a.axes_ | b.axes_); }
  friend Support cross(Support a, Support b) {
    return Support((a.next() & b.previous()) | (a.previous() & b.next()));
  }
  // May a dot product differ from 0?
  friend bool meet(Support a, Support b) { return (a.axes_ & b.axes_) != 0; }

 private:
  explicit constexpr Support(unsigned axes) : axes_(axes) {}
  // With axis k where this has k + 1, or k + 2.
  unsigned next() const { return (axes_ >> 1 | axes_ << 2) & all_axes; }
  unsigned previous() const { return (axes_ >> 2 | axes_ << 1) & all_axes; }

  unsigned axes_ = 0;
};

// Of what ForceOnSurface (surface.hpp) computes with.
struct SurfaceSupport {
  Support normal, forward, force;
  bool has_friction, has_brake;

  bool may_pull_along() const { return meet(forward, force); }
  bool may_pull_across() const { return meet(forward, cross(normal, force)); }
  bool may_turn() const { return !cross(normal, force).is_empty(); }

  // By the formulas of lemma clipping-without-axes.
  Support clipped(Clipping clipping) const {
    const Support rightward = may_pull_across() ? cross(forward, normal) : Support();
    switch (clipping) {
      case Clipping::onto_band_edge:
        return has_brake ? force | forward : rightward | normal;
      case Clipping::onto_corner:
        return (has_brake ? forward : Support()) | rightward | normal;
      case Clipping::onto_circle:
        return has_friction ? force | normal : normal;
      default:
        return force;
    }
  }
};

}  // namespace groundtruth::fast
