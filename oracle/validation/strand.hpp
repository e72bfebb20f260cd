#pragma once
// A strand of generated cases. Most are fresh; where an answer was wrong, or the exact answer came about in a
// way not seen before in this strand, the case breeds: it is changed a little and asked again.

#include <memory>

#include <groundtruth/validation/stream.hpp>

namespace groundtruth::validation {

// Which kinds are asked, in shares of a batch. Not all may be 0.
struct Shares {
  unsigned entry = 60;
  unsigned clip = 15;
  unsigned step = 25;
};

struct StrandPlan {
  std::uint64_t seed = 1;
  std::uint64_t number = 0;
  std::uint64_t cases = 0;
  // It ends with the batch in which it has failed so often; 0: never.
  std::uint64_t most_failures = 0;
  Shares shares;
};

// The same for the same plan and the same findings.
std::unique_ptr<Stream> strand_of(const StrandPlan& plan);

}  // namespace groundtruth::validation
