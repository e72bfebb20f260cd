#pragma once
// All the cases of a validation: those known to fail, the corpus, then strands of generated ones.

#include <cstdint>
#include <optional>
#include <vector>

#include <groundtruth/validation/run.hpp>
#include <groundtruth/validation/strand.hpp>

namespace groundtruth::validation {

// Part `index` of `count`, from 1. The parts are disjoint, and together they are the whole.
struct Shard {
  std::uint64_t index = 1;
  std::uint64_t count = 1;
};

struct Selection {
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> cases;  // of corpus and strands, over all shards; absent: no end
  Shard shard;
  Shares shares;
  std::uint64_t most_failures = 200;  // about so many are sought, over all strands of all shards; 0: no end
};

inline constexpr std::uint64_t cases_of_strand = 1000;

StreamAt course_of(const Selection& selection);

}  // namespace groundtruth::validation
