#pragma once
// Phi with the errors of the source, or without.

#include <groundtruth/as_written/errata.hpp>
#include <groundtruth/as_written/scene.hpp>
#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::as_written {

// The entry point in plain doubles: by recursion (recursion.hpp), the leaf by the local cone
// (local_shape.hpp). There is no error bound: near a face, hit, leaf and lambda may all be wrong, and an
// overflow on the way may make a miss of a hit. But every answer is finite and, but for
// Erratum::miss_is_plus_1000, lambda lies in the range. A miss that reads as a hit (that erratum, from 2^63
// on) is answered as Inside at the end of the range.
//
// Errata that matter here: single_pass_intersection, normal_by_order, miss_is_plus_1000.
EntryAnswer entry_point(const Scene& scene, const EntryAsk& ask, const Errata& errata);

}  // namespace groundtruth::as_written
