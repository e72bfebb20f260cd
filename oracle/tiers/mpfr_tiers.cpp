#include <boost/multiprecision/mpfr.hpp>

#include <groundtruth/tiers/factories.hpp>
#include <groundtruth/tiers/naive/naive_tier.hpp>

namespace groundtruth::tiers {

// Boost counts digits and rounds the bits up: 38 and 77 digits make 128 and 257 bits.
template <unsigned digits>
using Mpfr = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<digits, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;

MadeTier make_mpfr_128_tier() {
  return std::make_unique<naive::NaiveTier<Mpfr<38>>>("mpfr-128", "plain recursion in MPFR at 128 bits");
}

MadeTier make_mpfr_256_tier() {
  return std::make_unique<naive::NaiveTier<Mpfr<77>>>("mpfr-256", "plain recursion in MPFR at 257 bits");
}

}  // namespace groundtruth::tiers
