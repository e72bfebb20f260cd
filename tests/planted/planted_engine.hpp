#pragma once
// Planted implementations as engines: the bugs, and some that are right.

#include <groundtruth/implementations/engine.hpp>

#include "bug.hpp"

namespace groundtruth::planted {

std::unique_ptr<const implementations::Engine> make_engine_of(std::string_view name, Prepare prepare);

// Implementations without a mistake, which must not be accused of one.
struct RightOne {
  std::string_view name;
  std::string_view oddity;  // one line
  Prepare on;
  std::string (*rephrase)(std::string line);  // what becomes of each answer line
};
const std::vector<RightOne>& right_ones();

}  // namespace groundtruth::planted
