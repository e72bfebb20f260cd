#include <groundtruth/precision/comparison.hpp>

#include <algorithm>

namespace groundtruth::precision {
namespace {

const TierFigure* find(const std::vector<TierFigure>& figures, const std::string& study,
                       const std::string& tier) {
  const auto found = std::find_if(figures.begin(), figures.end(), [&](const TierFigure& figure) {
    return figure.study == study && figure.tier == tier;
  });
  return found == figures.end() ? nullptr : &*found;
}

// Relative to the plain doubles of the same study; as it stands if there are none.
double relative_time(const std::vector<TierFigure>& figures, const TierFigure& figure) {
  const TierFigure* plain = find(figures, figure.study, "double");
  return plain && plain->nanoseconds > 0 ? figure.nanoseconds / plain->nanoseconds : figure.nanoseconds;
}

double share(const TierFigure& figure) {
  return figure.asks == 0 ? 0 : static_cast<double>(figure.unanswered) / static_cast<double>(figure.asks);
}

}  // namespace

std::vector<Regression> regressions(const std::vector<TierFigure>& before, const std::vector<TierFigure>& now,
                                    double threshold) {
  constexpr double rounding = 0.5;
  std::vector<Regression> found;
  for (const TierFigure& old : before) {
    const TierFigure* other = find(now, old.study, old.tier);
    const auto note = [&](const char* what, double was, double is) {
      found.push_back({old.study, old.tier, what, was, is});
    };
    if (other == nullptr) {
      note("missing", 1, 0);
      continue;
    }
    const double time_before = relative_time(before, old), time_now = relative_time(now, *other);
    if (time_now > (1 + threshold) * time_before) note("time relative to double", time_before, time_now);
    const double error_before = std::max(old.worst_ulps, rounding);
    if (other->worst_ulps > (1 + threshold) * error_before)
      note("worst error, ulp", old.worst_ulps, other->worst_ulps);
    if (share(*other) > (1 + threshold) * share(old))
      note("share without a right answer", share(old), share(*other));
  }
  return found;
}

}  // namespace groundtruth::precision
