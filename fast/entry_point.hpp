#pragma once
// The entry point (Phi) in doubles.

#include <groundtruth/fast/scene.hpp>
#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::fast {

// Where the ask's segment first meets the scene's solid: SPEC section 3.
// 1. Every crossing of the segment with a plane is rounded once; hit or miss and lambda are exact for the
//    crossings so rounded. The answer is always one of the three kinds; its lambda is finite, in the range.
// 2. Where coordinates, normals and offsets are so short (small integers, say) that no Delta is rounded, hit
//    or miss, face and material are exact and lambda is correctly rounded.
// 3. Otherwise all decisions (hit or miss, face, material) and lambda are those of plain doubles: unproved,
//    without an error bound.
// 4. Safe for concurrent asks on one scene. No allocation, unless more than 64 leaves and operators are left
//    of the scene's expression once it is simplified for the point.
// Requires what the ask requires (finite numbers, lambda_first <= lambda_last).
EntryAnswer entry_point(const Scene& scene, const EntryAsk& ask);

}  // namespace groundtruth::fast
