#pragma once
// What compiling a scene leaves out, and what that is worth in time.

#include <cstdint>
#include <string>
#include <vector>

#include <groundtruth/precision/measurement.hpp>
#include <groundtruth/problem/scene.hpp>

namespace groundtruth::precision {

struct LeftOutWorth {
  std::string scene;
  std::string what;       // a simplification's name; "all" for all of them together
  std::size_t count = 0;  // of the things dropped, or of those that an index holds
  std::string why;
  std::size_t asks = 0;
  Spread with_ns;             // an ask, as compiled
  Spread without_ns;          // with this left off
  bool same_answers = false;  // to the last bit, on all these asks
};

// On ordinary entry asks: scenes compiled with all simplifications, with each that did something left off,
// and with all left off; all in turns in one run.
std::vector<LeftOutWorth> worth_of_left_out(const std::string& name, const std::vector<Scene>& pack,
                                            std::uint64_t seed, std::size_t asks, int rounds);

}  // namespace groundtruth::precision
