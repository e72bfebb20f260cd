#pragma once
// Cases that are one step simpler than a given one, or may be: the caller compares sizes. Private to this
// folder.

#include <vector>

#include <groundtruth/cases/case.hpp>

namespace groundtruth::diagnosis {

using Cases = std::vector<cases::Case>;

// A node replaced by one of its operands, or by everything or nothing; operands left out, many at a time
// where there are many; materials and paints taken off.
Cases with_simpler_shape(const cases::Case& from);

// What has several numbers made ordinary at once: range, orientation, velocities, wheel, state, brake; and
// the world moved to the origin.
Cases with_ordinary_ask(const cases::Case& from);

// A number, wherever it stands, made simpler: alone, and together with all that equal it.
Cases with_simpler_numbers(const cases::Case& from);

}  // namespace groundtruth::diagnosis
