#pragma once
// The scenes built into the program, by name.

#include <string_view>
#include <vector>

#include <groundtruth/problem/scene.hpp>

namespace groundtruth::cases {

struct BuiltinScene {
  std::string_view name;
  std::string_view description;   // one line
  std::vector<Scene> (*build)();  // one scene, or the scenes of a pack; always the same
};

// In the order in which reports show them:
//   house       the seven-plane house                                   7 leaves
//   runway      200 abutting boxes with a wet patch                 1,200 leaves
//   town        1,000 houses on the ground                          7,001 leaves
//   hills       800 prisms with shared faces                        4,000 leaves
//   ramp        flat ground, ramp and deck, with ice                   17 leaves
//   degenerate  a pack of small degenerate scenes
//   nested      a pack of random nested expressions
//   far-town    20 houses moved by (1e6, -1e6, 1e3) m; their features are multiples of 2^-10 m, which stay
//   exact
const std::vector<BuiltinScene>& builtin_scenes();

// Null if there is none of this name.
const BuiltinScene* find_builtin_scene(std::string_view name);

}  // namespace groundtruth::cases
