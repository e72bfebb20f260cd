#pragma once
// A range as boxes in floats see it. Not installed.

namespace groundtruth::fast {

// Of a range's ends. Further out floats are too coarse to cut anything off, or nothing is known.
[[gnu::always_inline]] inline bool suit_boxes(double greatest_coordinate, double coordinate_error) {
  return greatest_coordinate < 0x1p60 && coordinate_error < 1;
}

// Per axis, as lemma box-slabs has it (box_probe.hpp).
struct BoxWay {
  float near_origin[3];
  float far_origin[3];
  float inverse[3];
  bool is_ascending[3];
};

}  // namespace groundtruth::fast
