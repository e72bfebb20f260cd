#pragma once
// Where the vectors of a step are exactly 0. Not installed.

#include <groundtruth/fast/support.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::fast {

// Of the wheel's axes in world coordinates. Requires |q|^2 in [2^-100, 2^100].
struct AxesSupport {
  Support rightward, downward;
};
AxesSupport support_of_axes(const Quaternion& world_from_wheel);

// Of a wheel in contact, in world coordinates (lemma exact-zeros, proofs-notes/rounding-of-forces.md, section
// 12). Requires what AxesSupport does.
struct StepSupport {
  StepSupport(const StepAsk& ask, const Contact& contact, double friction);

  Support of_offset(Clipping clipping) const;
  Support of_way(Clipping clipping) const { return of_offset(clipping) | downward; }
  Support of_move(Clipping clipping) const { return of_way(clipping) | arm; }

  Relocation relocation;
  Support downward, arm, velocity;
  SurfaceSupport surface;
};

}  // namespace groundtruth::fast
