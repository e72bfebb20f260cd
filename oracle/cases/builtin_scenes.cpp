#include <cstdint>
#include <utility>

#include <groundtruth/cases/builtin_scenes.hpp>
#include <groundtruth/cases/degenerate_scenes.hpp>
#include <groundtruth/cases/random.hpp>
#include <groundtruth/cases/scene_builders.hpp>

namespace groundtruth::cases {
namespace {

constexpr std::uint64_t town_seed = 1;

std::vector<Scene> degenerate_pack() {
  std::vector<Scene> pack;
  for (auto make : {thin_scenes, coincident_scenes, odd_plane_scenes, odd_expression_scenes}) {
    for (Scene& scene : make()) pack.push_back(std::move(scene));
  }
  return pack;
}

// From two operands to expressions of a few dozen leaves.
std::vector<Scene> nested_pack() {
  std::vector<Scene> pack;
  for (std::uint64_t i = 0; i < 32; ++i) {
    const unsigned depth = 1 + static_cast<unsigned>(i % 4);
    pack.push_back(random_nested(seed_of_part(town_seed, i), depth, depth == 1 ? 3 : 4));
  }
  return pack;
}

}  // namespace

const std::vector<BuiltinScene>& builtin_scenes() {
  static const std::vector<BuiltinScene> scenes{
      {"house", "the seven-plane house", [] { return std::vector<Scene>{house()}; }},
      {"runway", "200 abutting boxes, one top plane, a wet patch",
       [] { return std::vector<Scene>{runway_of(200)}; }},
      {"town", "1,000 houses on the ground", [] { return std::vector<Scene>{town_of(1000, town_seed)}; }},
      {"hills", "a heightfield of 800 prisms with shared faces",
       [] { return std::vector<Scene>{hills_of(20)}; }},
      {"ramp", "flat ground, a ramp and a deck, with ice", [] { return std::vector<Scene>{ramp()}; }},
      {"degenerate", "a pack of degenerate shapes", degenerate_pack},
      {"nested", "a pack of random nested expressions", nested_pack},
      {"far-town", "20 houses, 1,000 km away, with millimetre features",
       [] {
         return std::vector<Scene>{shifted(town_of(20, town_seed), {1e6, -1e6, 1e3})};
       }},
  };
  return scenes;
}

const BuiltinScene* find_builtin_scene(std::string_view name) {
  for (const BuiltinScene& scene : builtin_scenes()) {
    if (scene.name == name) return &scene;
  }
  return nullptr;
}

}  // namespace groundtruth::cases
