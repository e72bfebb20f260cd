#pragma once
// The last stage of a step (SPEC section 5): in exact numbers, for any doubles at all. Not installed.

#include <groundtruth/fast/exact_stage/strut.hpp>
#include <groundtruth/fast/scene.hpp>
#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::fast::exact_stage {

// Every decision as SPEC section 5 has it, every number correctly rounded. Only a free wheel and a slip look
// at the ground; the scene is asked for materials.
StepAnswer step(const Scene& scene, Ground& ground, const StepAsk& ask);

}  // namespace groundtruth::fast::exact_stage
