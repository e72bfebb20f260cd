#pragma once

#include <vector>

#include <groundtruth/definition/expression.hpp>
#include <groundtruth/problem/scene.hpp>

namespace groundtruth::definition {

struct PreparedScene {
  std::vector<Material> materials;
  Expression solid;
};

}  // namespace groundtruth::definition
