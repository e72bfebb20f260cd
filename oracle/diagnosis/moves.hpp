#pragma once
// Cases that are one step simpler than a given one, or may be: the caller compares sizes. Private to this
// folder.

#include <functional>

#include <groundtruth/cases/case.hpp>

namespace groundtruth::diagnosis {

// Is told the candidates one by one, each made only then: a scene may be large and its moves many. False: no
// more of them.
using Take = std::function<bool(cases::Case&&)>;

// False as soon as `take` is.
using Moves = bool (*)(const cases::Case& from, const Take& take);

// A node replaced by one of its operands, or by everything or nothing; operands left out, many at a time
// where there are many; materials and paints taken off.
bool with_simpler_shape(const cases::Case& from, const Take& take);

// What has several numbers made ordinary at once: range, orientation, velocities, wheel, state, brake; and
// the world moved to the origin.
bool with_ordinary_ask(const cases::Case& from, const Take& take);

// A number, wherever it stands, made simpler: together with all that equal it, and alone.
bool with_simpler_numbers(const cases::Case& from, const Take& take);

}  // namespace groundtruth::diagnosis
