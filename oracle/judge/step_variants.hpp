#pragma once
// The steps around a step that a tolerance allows. Private to this folder.

#include <vector>

#include "step_scales.hpp"
#include "truth.hpp"

namespace groundtruth::judge {

// Asks that differ from this one in their thresholds, each moved by the tolerance's part of its scale: those
// of the outcome of `got` towards it, those before it away from it; with the pebble borders around the ask's
// (SPEC section 6; proofs-notes/tolerance.md, 3). If a step whose decisions are each within the tolerance
// ends as `got` does, one of these does, exactly.
std::vector<StepAsk> asks_towards(const StepAnswer& got, const StepAsk& ask, const StepScales& scales,
                                  const Tolerance& tolerance);

}  // namespace groundtruth::judge
