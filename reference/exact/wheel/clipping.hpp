#pragma once
// The clip of SPEC section 4 on exact numbers. Private to this folder; derivation: proofs-notes/clipping.md.

#include <groundtruth/exact/arithmetic/root_sum.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::exact {

// Whether an orientation on the surface means something. The normal is not necessarily of unit length.
bool is_upright(const RationalVector& normal_in_wheel, const Rational& min_uprightness);

struct PebbleBorder {
  Rational friction;  // mu >= 0
  Rational brake;     // B >= 0, N
};

struct ExactClip {
  Grip grip = Grip::stick;
  RootVector force_in_wheel;
};

// Requires that the surface is upright.
ExactClip clip_force(const RationalVector& force_in_wheel, const RationalVector& normal_in_wheel,
                     const PebbleBorder& border);

}  // namespace groundtruth::exact
