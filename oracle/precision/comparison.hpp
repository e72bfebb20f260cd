#pragma once
// What became slower or less exact between two reports.

#include <cstddef>
#include <string>
#include <vector>

namespace groundtruth::precision {

// A tier on one study, as far as reports are compared.
struct TierFigure {
  std::string study;  // "town/entry/hostile"
  std::string tier;
  std::size_t asks = 0;
  std::size_t unanswered = 0;  // wrong or undecided
  double worst_ulps = 0;
  double nanoseconds = 0;
};

struct Regression {
  std::string study;
  std::string tier;
  std::string
      what;  // "time relative to double", "worst error, ulp", "share without a right answer", "missing"
  double before = 0;
  double now = 0;
};

// All of: a tier's time, relative to that of the tier "double" on the same study (so that another machine
// does not count), is more than (1 + threshold) times what it was; its worst error is, where it is beyond the
// half ulp of rounding; a larger share of its asks got no right answer; it, or its study, is missing now. A
// tier that answered fewer asks than before is as good as its share.
std::vector<Regression> regressions(const std::vector<TierFigure>& before, const std::vector<TierFigure>& now,
                                    double threshold);

}  // namespace groundtruth::precision
