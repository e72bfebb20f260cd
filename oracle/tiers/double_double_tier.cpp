#include <groundtruth/tiers/factories.hpp>
#include <groundtruth/tiers/naive/naive_tier.hpp>
#include <groundtruth/tiers/numbers/double_double.hpp>

namespace groundtruth::tiers {

MadeTier make_double_double_tier() {
  return std::make_unique<naive::NaiveTier<DoubleDouble>>("double-double",
                                                          "plain recursion on pairs of doubles (106 bits)");
}

}  // namespace groundtruth::tiers
