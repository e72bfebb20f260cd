#pragma once
// From a failing case to a smallest one that fails in the same way.

#include <chrono>
#include <functional>
#include <span>
#include <vector>

#include <groundtruth/diagnosis/size.hpp>

namespace groundtruth::diagnosis {

// Which of these cases fail in the way in question? Several at once, so that one journey through a pipe
// serves all.
using StillFail = std::function<std::vector<bool>(std::span<const cases::Case>)>;

struct Budget {
  std::size_t most_asks = 4000;
  std::chrono::milliseconds most_time{2000};
};

struct Shrunk {
  cases::Case smallest;  // fails; `failing` itself if nothing smaller does
  Size before;
  Size after;
  std::size_t asks = 0;
  bool is_minimum = false;  // no move leads further; else the budget was spent
};

// Guarantees: well-formed cases only are asked (inputs.hpp), each smaller than the last that failed; the
// result is a function of the arguments unless time runs out. Requires that `failing` fails.
Shrunk shrink(const cases::Case& failing, const StillFail& still_fail, const Budget& budget = {});

}  // namespace groundtruth::diagnosis
