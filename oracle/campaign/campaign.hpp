#pragma once
// Every engine on the same asks, held against the exact one.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <groundtruth/campaign/tally.hpp>
#include <groundtruth/cases/ask_source.hpp>
#include <groundtruth/implementations/engine.hpp>
#include <groundtruth/problem/scene.hpp>

namespace groundtruth::campaign {

// One ask in this many, of each kind, is put to an engine: 1 where it is quick enough for all, 0 where it
// answers none.
struct Sampling {
  std::uint64_t entry = 1;
  std::uint64_t clip = 1;
  std::uint64_t step = 1;
};

// What the definition can answer of a scene with this many leaves in the time of a check.
Sampling definition_sampling(std::size_t leaves);
// The same of the proved witness, which answers entry asks only.
Sampling proved_sampling(std::size_t leaves);

struct Plan {
  std::vector<Scene> pack;           // the asks are shared out over its scenes
  std::vector<std::string> engines;  // names that make_engine() knows; the first is the exact one
  std::uint64_t seed = 1;
  std::uint64_t asks = 0;
  unsigned jobs = 1;
};

// The asks put to a scene of the pack; a function of the plan's seed and the scene and its place alone.
cases::AskSource asks_for(const Plan& plan, std::size_t part);

// Puts the plan's asks to every engine and counts, an engine after the other on each few asks, so that what
// slows the machine slows all. One tally an engine. `progress` is given the number of asks done now and then,
// never from two threads at once.
std::vector<Tally> run(const Plan& plan, const std::function<void(std::uint64_t)>& progress);

}  // namespace groundtruth::campaign
