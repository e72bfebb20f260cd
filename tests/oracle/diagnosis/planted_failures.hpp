#pragma once
// Failures whose cause is known, because the test says what fails.

#include <groundtruth/diagnosis/shrink.hpp>
#include <groundtruth/problem/answer.hpp>

namespace groundtruth::diagnosis {

using Fails = bool (*)(const cases::Case&);

StillFail each(Fails fails);

// Three planes or more, no two of them parallel, meet at the entry point.
bool has_corner(const cases::Case& with);
bool has_range_start(const cases::Case& with);
// A clip whose brake is the friction times F_z.
bool has_brake_at_limit(const cases::Case& with);
// The material at the entry point is another without paints.
bool has_paint(const cases::Case& with);
bool slips_and_turns(const cases::Case& with);

// From the generated asks about the built-in scenes up to so many leaves, those that fail so; at most `most`,
// at most two a scene.
std::vector<cases::Case> messy_cases(Fails fails, std::size_t most, std::size_t most_leaves = 60);

}  // namespace groundtruth::diagnosis
