#pragma once
// What is known of where a range first lies in a part of the solid. Not installed.
//
// Positions in a range are numbers s in [0, 1]: 0 at its first end, 1 at its last.

#include <cstdint>

namespace groundtruth::fast {

inline constexpr std::uint32_t no_place = 0xffffffff;

// lower <= s <= upper for the first s at which the range lies in the part, if it does at all; `upper` is 2
// unless it certainly does. lower > 1: it certainly misses. upper < 0: the range starts in the part's
// interior.
struct Meeting {
  double lower = 0;
  double upper = 2;
  // Of a cell that is certainly hit, lower > 0: the place of its one half-space through which the range can
  // enter it at lower to upper. no_place: there may be several, or nothing is known.
  std::uint32_t sole_place = no_place;

  bool misses() const { return lower > 1; }
  bool certainly_hits() const { return upper <= 1; }
  bool starts_inside() const { return upper < 0; }
};

inline constexpr Meeting no_meeting{2, 2, no_place};

}  // namespace groundtruth::fast
