#pragma once
// A clip's answer together with the stage that decided it, for tests and histograms. Not installed.

#include <groundtruth/fast/stage.hpp>
#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::fast {

struct DecidedClip {
  ClipAnswer answer;
  Stage stage = Stage::exact;
};

// clip() is its answer.
DecidedClip decide_clip(const ClipAsk& ask);

}  // namespace groundtruth::fast
