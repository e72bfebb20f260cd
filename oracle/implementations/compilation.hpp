#pragma once
// What the engine `fast` makes of a scene before it is asked anything.

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <groundtruth/implementations/engine.hpp>
#include <groundtruth/problem/scene.hpp>

namespace groundtruth::implementations {

struct LeftOut {
  std::string what;       // "constants", "duplicates", "hierarchy", ...
  std::size_t count = 0;  // of the things dropped, or of those that an index holds
  std::string why;
};

struct Compilation {
  std::size_t half_spaces = 0;    // leaves as written
  std::size_t convex_parts = 0;   // of the union that the solid is
  std::size_t general_parts = 0;  // operands that are no intersections of half-spaces
  double seconds = 0;             // that compiling took
  std::vector<LeftOut> left_out;
};

Compilation compilation_of(const Scene& scene);

// What may be left out at all, by the names of LeftOut::what.
std::vector<std::string> simplification_names();

// The engine `fast` on a scene that is compiled without these. None changes an answer.
std::unique_ptr<const EngineOnScene> fast_without(const Scene& scene, const std::vector<std::string>& names);

}  // namespace groundtruth::implementations
