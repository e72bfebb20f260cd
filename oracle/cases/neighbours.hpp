#pragma once
// Asks next to a given one: some of the numbers that place it are moved by one ulp (random.hpp). The result
// is well formed if the ask is.

#include <groundtruth/cases/random.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::cases {

// Both ends; the range stays.
EntryAsk neighbour(const EntryAsk& ask, Random& random);

// Force, normal, friction and brake.
ClipAsk neighbour(const ClipAsk& ask, Random& random);

// The frame's position, the brake, and of a contact its pebble, normal, friction and maximum force.
StepAsk neighbour(const StepAsk& ask, Random& random);

}  // namespace groundtruth::cases
