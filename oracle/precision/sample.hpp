#pragma once
// The asks that tiers are measured with, and their exact answers.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <groundtruth/implementations/engine.hpp>
#include <groundtruth/problem/scene.hpp>
#include <groundtruth/tiers/tier.hpp>

namespace groundtruth::precision {

enum class Population {
  ordinary,  // segments and struts anywhere, forces and wheels as they occur
  hostile    // made to hit faces, edges, corners, seams and borders exactly or by an ulp; extreme numbers
};

std::string_view name_of(Population population);
std::string_view name_of(tiers::AskKind kind);

struct Case {
  std::size_t part = 0;     // which scene of the pack
  std::uint64_t index = 0;  // in that scene's stream of asks: `groundtruth check --show SCENE:PART:INDEX`
  Ask ask;
  implementations::Answered truth;  // of the exact engine, its numbers not rounded
};

struct Sample {
  std::string scene;  // the pack's name
  tiers::AskKind kind = tiers::AskKind::entry;
  Population population = Population::ordinary;
  std::uint64_t seed = 1;
  std::vector<Scene> pack;
  std::vector<Case> cases;
};

// The first `count` asks of that kind and population in the streams of the pack's scenes, taken in turn;
// fewer if they are rare.
Sample draw(const std::string& scene, const std::vector<Scene>& pack, tiers::AskKind kind,
            Population population, std::uint64_t seed, std::size_t count);

}  // namespace groundtruth::precision
