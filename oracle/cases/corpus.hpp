#pragma once
// The worst cases found so far, by name: what every implementation is asked first, and what
// `groundtruth vectors` freezes.

#include <vector>

#include <groundtruth/cases/case.hpp>

namespace groundtruth::cases {

// Ids are distinct and stay: a case may be added, never renamed or changed. Each has a flag or more and a
// note. Flags: "seam", "corner", "edge", "sheet", "grazing", "start-on-face", "inside", "one-ulp",
// "big-world", "range", "expression", "paint", "empty"; "steep", "band-corner", "border", "brake",
// "friction", "tensile", "lift-off", "broken", "gave-way", "relocation", "return-mapping", "omega",
// "orientation", "damping", "refusal"; and the name of each erratum of SPEC section 7 that the case shows.
const std::vector<Case>& corpus();

}  // namespace groundtruth::cases
