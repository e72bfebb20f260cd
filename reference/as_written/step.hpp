#pragma once
// One step of a wheel, with the errors of the source or without.

#include <groundtruth/as_written/errata.hpp>
#include <groundtruth/as_written/scene.hpp>
#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::as_written {

// The step of SPEC section 5 in plain doubles, its Phi being that of entry_point.hpp and its clip that of
// clip.hpp, with the same errata. Any decision within rounding of its limit may fall either way. A pebble
// that sticks stays where it is bit for bit. Any number on the way that no double holds is a Refusal that
// names it.
//
// Errata that matter here: all.
StepAnswer step(const Scene& scene, const StepAsk& ask, const Errata& errata);

}  // namespace groundtruth::as_written
