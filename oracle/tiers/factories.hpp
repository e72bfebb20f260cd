#pragma once
// Who makes which tier. Private to this folder: each is defined in the only file that includes its numbers.

#include <groundtruth/tiers/tier.hpp>

namespace groundtruth::tiers {

using MadeTier = std::unique_ptr<const Tier>;

MadeTier make_float_tier();
MadeTier make_double_tier();
MadeTier make_long_double_tier();
MadeTier make_double_double_tier();
MadeTier make_interval_tier();
MadeTier make_cpp_bin_float_tier();
MadeTier make_mpfr_128_tier();
MadeTier make_mpfr_256_tier();
MadeTier make_cgal_lazy_tier();

// Of an engine of this program (implementations/engine.hpp).
MadeTier make_engine_tier(const std::string& engine, const std::string& description);

}  // namespace groundtruth::tiers
