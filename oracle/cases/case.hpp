#pragma once
// An ask with its scene: what an implementation is judged on, shrunk to and replayed from.

#include <string>
#include <vector>

#include <groundtruth/problem/ask.hpp>
#include <groundtruth/problem/scene.hpp>

namespace groundtruth::cases {

struct Case {
  std::string id;  // stable, and enough to make or find the case again
  Scene scene;     // nothing, where the ask needs none
  Ask ask;
  std::vector<std::string> flags;  // "seam", "corner", "grazing", "one-ulp", ...
  std::string note;                // why the case exists; may be empty
};

}  // namespace groundtruth::cases
