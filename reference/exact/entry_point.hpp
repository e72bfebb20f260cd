#pragma once
// Phi, the entry point, exactly (SPEC section 3).

#include <groundtruth/exact/finding.hpp>
#include <groundtruth/exact/scene.hpp>

namespace groundtruth::exact {

// Guarantees, for every ask of finite doubles with lambda_first <= lambda_last:
// 1. hit or miss, lambda, interior, the admissible leaves, the canonical leaf and its material are those of
// the
//    exact problem that these doubles pose (recursion: proofs-notes/entry-point.md; faces:
//    proofs-notes/faces.md);
// 2. `lambda` is the exact one rounded to nearest; `Evidence::lambda_exact` is not rounded at all.
// Units and frame: world, metres. Never fails but for want of memory.
Finding<EntryAnswer> entry_point(const Scene& scene, const EntryAsk& ask, Digits digits = Digits::none);

}  // namespace groundtruth::exact
