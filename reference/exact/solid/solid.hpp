#pragma once
// A scene as the exact engine walks it. Private to this folder.

#include <cstddef>
#include <optional>
#include <vector>

#include <groundtruth/exact/solid/expression.hpp>
#include <groundtruth/problem/scene.hpp>

namespace groundtruth::exact {

// A solid: its expression and the half-spaces that its leaves stand for.
struct Solid {
  Expression expression;
  std::vector<HalfSpace> half_spaces;  // by leaf
};

// One material over part of the leaves, wherever `region` is, everywhere if it is absent.
struct Layer {
  MaterialIndex material = 0;
  std::optional<Solid> region;
  Leaf first_leaf = 0;
  Leaf end_leaf = 0;
};

struct Ground {
  Solid solid;
  std::vector<Layer> layers;  // an outer layer stands before the ones within it
  std::vector<Material> materials;
};

Ground lay_out(const groundtruth::Scene& scene);

}  // namespace groundtruth::exact
