#pragma once
// The second witness of the entry point (SPEC section 3): shares no algorithm with the reference.

#include <groundtruth/definition/scene.hpp>
#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::definition {

struct EntryFinding {
  EntryAnswer answer;  // lambda correctly rounded; the canonical leaf
  Evidence evidence;   // lambda_exact and admissible
};

// Exact. Requires finite numbers and lambda_first <= lambda_last.
EntryFinding entry_point(const Scene& scene, const EntryAsk& ask);

}  // namespace groundtruth::definition
