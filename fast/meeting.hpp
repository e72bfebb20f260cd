#pragma once
// What is known of where a range first lies in a part of the solid. Not installed.
//
// Positions in a range are numbers s in [0, 1]: 0 at its first end, 1 at its last.

namespace groundtruth::fast {

// lower <= s <= upper for the first s at which the range lies in the part, if it does at all; `upper` is 2
// unless it certainly does. lower > 1: it certainly misses. upper < 0: the range starts in the part's
// interior.
struct Meeting {
  double lower = 0;
  double upper = 2;

  bool misses() const { return lower > 1; }
  bool certainly_hits() const { return upper <= 1; }
  bool starts_inside() const { return upper < 0; }
};

inline constexpr Meeting no_meeting{2, 2};

}  // namespace groundtruth::fast
