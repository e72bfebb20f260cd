#pragma once
// Has a motion come back to a state that it was in, to the last bit? Then, driven by constant inputs, it
// repeats itself for ever, and the rest of it is known. Private to this folder.

#include <optional>

#include <groundtruth/rig/machine.hpp>

namespace groundtruth::rig {

// Brent's cycle detection: remembers one state, and another after ever longer waits.
class Recurrence {
 public:
  // The number of steps after which the motion repeats itself, once that is seen. To be shown every state.
  std::optional<std::uint64_t> period_at(const MotionState& state);

 private:
  std::optional<MotionState> remembered_;
  std::uint64_t patience_ = 1;
};

}  // namespace groundtruth::rig
