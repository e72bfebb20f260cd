#pragma once
// How step asks are made. Each of these makes one of the flavour of its name; see flavour.hpp.

#include <groundtruth/cases/landmarks.hpp>
#include <groundtruth/cases/random.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::cases {

StepAsk step_free_hit(const Landmarks& landmarks, Random& random);
StepAsk step_free_miss(const Landmarks& landmarks, Random& random);
StepAsk step_free_limits(const Landmarks& landmarks, Random& random);
StepAsk step_free_in_ground(const Landmarks& landmarks, Random& random);

StepAsk step_resting(const Landmarks& landmarks, Random& random);
StepAsk step_skidding(const Landmarks& landmarks, Random& random);
StepAsk step_turning(const Landmarks& landmarks, Random& random);
StepAsk step_over_the_edge(const Landmarks& landmarks, Random& random);

StepAsk step_z_limits(const Landmarks& landmarks, Random& random);
StepAsk step_no_pressure(const Landmarks& landmarks, Random& random);
StepAsk step_gives_way(const Landmarks& landmarks, Random& random);
StepAsk step_border(const Landmarks& landmarks, Random& random);
StepAsk step_lands_on_feature(const Landmarks& landmarks, Random& random);
StepAsk step_steepness_limit(const Landmarks& landmarks, Random& random);

StepAsk step_stiff(const Landmarks& landmarks, Random& random);
StepAsk step_unknown_tyre(const Landmarks& landmarks, Random& random);
StepAsk step_extreme_bits(const Landmarks& landmarks, Random& random);

}  // namespace groundtruth::cases
