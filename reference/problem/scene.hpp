#pragma once
// A scene: what the ground is made of, and its solid (SPEC sections 2 and 8).

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <groundtruth/problem/shape.hpp>

namespace groundtruth {

// Coulomb coefficients of a pair of materials, both >= 0.
struct Friction {
  double static_coefficient = 0;
  double dynamic_coefficient = 0;
  bool operator==(const Friction&) const = default;
};

struct Material {
  std::string name;
  std::map<std::string, Friction> friction_by_tyre;  // keyed by the tyre's material: "rubber", "metal", ...
  std::optional<double> maximum_force;               // N, >= 0; absent: it never gives way
};

struct Scene {
  std::vector<Material> materials;  // names are distinct
  Shape shape;
};

}  // namespace groundtruth
