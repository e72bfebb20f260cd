#pragma once
// An endless stream of asks for a scene, the same for a scene and a seed on every platform.

#include <cstdint>

#include <groundtruth/cases/flavour.hpp>
#include <groundtruth/cases/landmarks.hpp>
#include <groundtruth/problem/ask.hpp>
#include <groundtruth/problem/scene.hpp>

namespace groundtruth::cases {

// Is the ask as the flavour makes it, or one of its neighbours (neighbours.hpp)?
enum class Placement { as_made, one_ulp_off };

struct GeneratedAsk {
  Ask ask;  // well formed (ask.hpp), and every number finite
  Flavour flavour = Flavour::entry_random;
  Placement placement = Placement::as_made;
};

// The shares of the three kinds. Not all may be 0.
struct AskMix {
  unsigned entry = 60;
  unsigned clip = 15;
  unsigned step = 25;
};

class AskSource {
 public:
  // Surveys the scene once (landmarks.hpp); keeps no reference to it.
  AskSource(const Scene& scene, std::uint64_t seed, const AskMix& mix = {});

  // Ask number `index`: a function of scene, seed, mix and index alone, so that threads may share a stream by
  // taking parts of its indices.
  GeneratedAsk ask_at(std::uint64_t index) const;

  // ask_at(0), ask_at(1), ...
  GeneratedAsk next() { return ask_at(next_index_++); }

 private:
  Landmarks landmarks_;
  std::uint64_t seed_;
  AskMix mix_;
  std::uint64_t next_index_ = 0;
};

}  // namespace groundtruth::cases
