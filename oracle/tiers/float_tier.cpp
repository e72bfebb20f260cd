#include <groundtruth/tiers/factories.hpp>
#include <groundtruth/tiers/naive/naive_tier.hpp>

namespace groundtruth::tiers {

MadeTier make_float_tier() {
  return std::make_unique<naive::NaiveTier<float>>("float", "plain recursion in 24-bit floats");
}

}  // namespace groundtruth::tiers
