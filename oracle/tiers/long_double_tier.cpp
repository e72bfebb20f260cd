#include <groundtruth/tiers/factories.hpp>
#include <groundtruth/tiers/naive/naive_tier.hpp>

namespace groundtruth::tiers {

MadeTier make_long_double_tier() {
  return std::make_unique<naive::NaiveTier<long double>>("long-double",
                                                         "plain recursion in long double (64 bits on x86)");
}

}  // namespace groundtruth::tiers
