#pragma once
// How precisely a decision had to be looked at. Not installed.

#include <cstdint>

namespace groundtruth::fast {

enum class Stage : std::uint8_t {
  none,         // there was nothing to decide
  doubles,      // with a proven bound
  quick_pair,   // in double-double, with a proven bound for the whole ask
  double_pair,  // in double-double, with a proven bound for each number
  exact
};

}  // namespace groundtruth::fast
