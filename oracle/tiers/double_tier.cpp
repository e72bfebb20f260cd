#include <groundtruth/tiers/factories.hpp>
#include <groundtruth/tiers/naive/naive_tier.hpp>

namespace groundtruth::tiers {

MadeTier make_double_tier() {
  return std::make_unique<naive::NaiveTier<double>>("double", "plain recursion in doubles (53 bits)");
}

}  // namespace groundtruth::tiers
