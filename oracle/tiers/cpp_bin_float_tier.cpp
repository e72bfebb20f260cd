#include <boost/multiprecision/cpp_bin_float.hpp>

#include <groundtruth/tiers/factories.hpp>
#include <groundtruth/tiers/naive/naive_tier.hpp>

namespace groundtruth::tiers {

using Number = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_50::backend_type,
                                             boost::multiprecision::et_off>;

MadeTier make_cpp_bin_float_tier() {
  return std::make_unique<naive::NaiveTier<Number>>(
      "cpp_bin_float_50", "plain recursion in Boost's cpp_bin_float_50 (50 digits, 168 bits)");
}

}  // namespace groundtruth::tiers
