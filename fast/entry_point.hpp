#pragma once
// The entry point (Phi).

#include <span>

#include <groundtruth/fast/scene.hpp>
#include <groundtruth/fast/threads.hpp>
#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::fast {

// Where the ask's segment first meets the scene's solid: SPEC section 3, exactly, for any finite doubles.
// 1. Hit or miss, interior or border, the canonical leaf and its material are those of the exact problem that
//    these doubles pose, and lambda is the exact one rounded to nearest. Doubles decide where a proven bound
//    allows it (lemmas clip-interval, range-ends, crossing-in-double-double: proofs-notes/rounding.md), exact
//    integers where not.
// 2. The same bits with every compiler, level of optimisation and processor.
// 3. Safe for concurrent asks on one scene. No allocation, unless more than 128 parts of the solid cannot be
//    told apart where the segment enters it, or more than 32 leaves of these are undecided.
// Requires what the ask requires (finite numbers, lambda_first <= lambda_last).
EntryAnswer entry_point(const Scene& scene, const EntryAsk& ask);

// Many asks at a time. For `Threads::all()` the machine's processors share them.
// 1. answers[i] is entry_point(scene, asks[i]), bit for bit, whatever the number of threads.
// 2. In a very large scene (some 200,000 parts and more) asks are answered in an order in which neighbours
//    follow each other, unless they stand so, and memory is asked for ahead. It notes 8 bytes an ask for
//    that, of 65,536 asks at a time and thread. Else they are answered as they stand.
// 3. Never more threads than asked for, and one for each 2,048 asks at most, so that a few stay with the
//    caller; all have ended when this returns. None is kept, nothing is global.
// Requires spans of one size that do not overlap.
void entry_points(const Scene& scene, std::span<const EntryAsk> asks, std::span<EntryAnswer> answers,
                  Threads threads = {});

}  // namespace groundtruth::fast
