#pragma once
// The entry point (Phi) in doubles.

#include <groundtruth/fast/scene.hpp>
#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::fast {

// Where the ask's segment first meets the scene's solid: SPEC section 3.
// 1. Every crossing of the segment with a plane is rounded once; the answer is the exact answer for those
//    rounded crossings, so it is always one of the three kinds, its lambda is finite and lies in the range.
// 2. Where the rounded crossings are the exact ones (small integers, say), hit, face and material are exact
// and
//    lambda is correctly rounded.
// 3. Otherwise all decisions (hit or miss, face, material) and lambda are those of plain doubles: unproved,
//    without an error bound.
// 4. Safe for concurrent asks on one scene. No allocation, unless more than 64 faces, edges of operators
//    included, meet at the point.
// Requires what the ask requires (finite numbers, lambda_first <= lambda_last).
EntryAnswer entry_point(const Scene& scene, const EntryAsk& ask);

}  // namespace groundtruth::fast
