#pragma once
// The wheel of the corpus: numbers that are short in binary. Private to this folder.

#include "corpus_parts.hpp"

namespace groundtruth::cases {

// Above the world's origin, its z pointing down: the ground z = 0 is at p_z = height.
inline StepAsk step_at(double height, WheelState state) {
  StepAsk ask;
  ask.wheel = {-65536, -65536, -1024, -1024, 0.25, 0.75, 0.75, "rubber"};
  ask.frame.position_in_world = {0, 0, height};
  ask.frame.world_from_wheel = {0, 1, 0, 0};
  ask.brake = 4096;
  ask.h = 0x1p-10;
  ask.state = std::move(state);
  return ask;
}

inline Contact contact_at_origin(Grip grip) { return {grip, {0, 0, 0}, {0, 0, 0}, {0, 0, 1}, 0.5, 0.25, {}}; }

}  // namespace groundtruth::cases
