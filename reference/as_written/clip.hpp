#pragma once
// Clipping a force against the pebble border, with the errors of the source or without.

#include <groundtruth/as_written/errata.hpp>
#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::as_written {

// The clip of SPEC section 4 in plain doubles. A force within rounding of the border may be taken for either
// side of it; one that sticks comes back bit for bit. A clipped force that no double holds is a Refusal.
//
// Errata that matter here: surface_frame_sign, band_test_wheel_x, signed_normal_force.
ClipAnswer clip(const ClipAsk& ask, const Errata& errata);

}  // namespace groundtruth::as_written
