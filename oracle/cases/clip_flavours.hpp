#pragma once
// How clip asks are made. Each of these makes one of the flavour of its name; see flavour.hpp.

#include <groundtruth/cases/random.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::cases {

ClipAsk clip_random(Random& random);
ClipAsk clip_disc_border(Random& random);
ClipAsk clip_band_edge(Random& random);
ClipAsk clip_border_corner(Random& random);
ClipAsk clip_case_border_1_2(Random& random);
ClipAsk clip_case_border_2_3(Random& random);
ClipAsk clip_wide_band(Random& random);
ClipAsk clip_zeros(Random& random);
ClipAsk clip_steepness_limit(Random& random);
ClipAsk clip_hopeless_surface(Random& random);
ClipAsk clip_extreme_bits(Random& random);

}  // namespace groundtruth::cases
