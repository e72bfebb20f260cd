#pragma once
// Error against time: every tier on the same asks.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <groundtruth/precision/sample.hpp>

namespace groundtruth::precision {

// An ask of the sample that shows something.
struct Witness {
  std::size_t part = 0;
  std::uint64_t index = 0;
  std::string ask;  // as a line of JSON
};

struct Spread {
  double median = 0;
  double least = 0;
  double most = 0;
};

struct TierResult {
  std::string tier;
  std::string description;
  std::string omitted;          // why nothing was asked; empty: it was
  std::size_t asks = 0;         // answered
  std::size_t wrong = 0;        // hit or miss, face, material, stick or slip, state, or a refusal, wrong
  std::size_t undecided = 0;    // by intervals that overlap
  std::size_t with_number = 0;  // rightly decided and with a number to measure: of these are the errors
  double median_ulps = 0;
  double worst_ulps = 0;  // found, not proved: a larger one may exist
  std::optional<Witness> worst;
  std::optional<Witness> first_wrong;
  Spread nanoseconds;          // an ask; over the rounds
  std::size_t timed_asks = 0;  // the first asks, so many
  bool is_on_front = false;

  // The share of asks that got no right answer.
  double share_unanswered() const {
    return asks == 0 ? 0 : static_cast<double>(wrong + undecided) / static_cast<double>(asks);
  }
};

struct Effort {
  double seconds_of_errors = 0.04;    // a tier may take so long over the errors,
  double seconds_of_a_round = 0.008;  // and so long over a round of timing
  int rounds = 5;
};

// One result a tier, in the order of tiers::tiers(). A tier that is too slow for all asks answers the first
// ones. Time is that of this thread on its processor, without preparing scenes; the tiers take turns, round
// by round.
std::vector<TierResult> measure(const Sample& sample, const Effort& effort);

// Is nothing else both as quick and as good? `results` get their is_on_front. Better is a smaller share
// unanswered; between equals, a smaller worst error (all up to 0.5 ulp being as good as doubles can be).
void mark_front(std::vector<TierResult>& results);

}  // namespace groundtruth::precision
