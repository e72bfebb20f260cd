#pragma once
// A clip's answer together with the stages that decided it, for tests and histograms. Not installed.

#include <groundtruth/fast/dispatch.hpp>
#include <groundtruth/fast/stage.hpp>
#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::fast {

struct DecidedClip {
  ClipAnswer answer;
  Stage decisions = Stage::none;
  Stage force = Stage::none;  // none: it is the ask's, or there is none
};

// clip() is its answer, whatever the kernels.
DecidedClip decide_clip(const ClipAsk& ask, Kernels kernels = best_kernels());

}  // namespace groundtruth::fast
