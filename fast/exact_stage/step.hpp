#pragma once
// The last stage of a step (SPEC section 5): in exact numbers, for any doubles at all. Not installed.

#include <groundtruth/fast/exact_stage/entry.hpp>
#include <groundtruth/fast/scene.hpp>
#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::fast::exact_stage {

// Every decision as SPEC section 5 has it, every number correctly rounded. `solid` is the scene's, or what is
// left of it along the strut (only a free wheel and a slip look at it); the scene is asked for materials.
StepAnswer step(const Scene& scene, const ExpressionView& solid, const StepAsk& ask);

}  // namespace groundtruth::fast::exact_stage
