#include <groundtruth/tiers/factories.hpp>
#include <groundtruth/tiers/naive/naive_tier.hpp>

namespace groundtruth::tiers {

MadeTier make_interval_tier() {
  return std::make_unique<naive::NaiveTier<Interval>>(
      "interval", "plain recursion on bounds in doubles: certain, or undecided");
}

}  // namespace groundtruth::tiers
