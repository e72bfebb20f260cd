#pragma once
// A well-formed ask like a given one, but for a change or two: numbers to neighbouring doubles, other signs
// and scales, ends and ranges moved to where something happens, other ranges, other states. What a change
// does is a function of the ask, the entry point and what `random` draws alone.

#include <optional>

#include <groundtruth/cases/random.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::cases {

// `entered_at`: lambda of the ask's exact entry point, if it has one.
EntryAsk changed(const EntryAsk& ask, std::optional<double> entered_at, Random& random);

ClipAsk changed(const ClipAsk& ask, Random& random);

StepAsk changed(const StepAsk& ask, Random& random);

}  // namespace groundtruth::cases
