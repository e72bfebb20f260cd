#pragma once
// A range as boxes in floats see it. Not installed.

namespace groundtruth::fast {

// Per axis, as lemma box-slabs has it (box_probe.hpp).
struct BoxWay {
  float near_origin[3];
  float far_origin[3];
  float inverse[3];
  bool is_ascending[3];
};

}  // namespace groundtruth::fast
