#pragma once
// A step's answer together with the stages that decided it, for tests and histograms. Not installed.

#include <groundtruth/fast/dispatch.hpp>
#include <groundtruth/fast/scene.hpp>
#include <groundtruth/fast/stage.hpp>
#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::fast {

struct DecidedStep {
  StepAnswer answer;
  Stage decisions = Stage::none;
  Stage numbers = Stage::none;
};

// step() is its answer, whatever the kernels.
DecidedStep decide_step(const Scene& scene, const StepAsk& ask, Kernels kernels = best_kernels());

}  // namespace groundtruth::fast
