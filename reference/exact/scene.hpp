#pragma once
// A scene, prepared for the exact engine.

#include <memory>

#include <groundtruth/problem/scene.hpp>

namespace groundtruth::exact {

struct Ground;

// Immutable: several threads may ask about one scene at once.
class Scene {
 public:
  explicit Scene(const groundtruth::Scene& scene);
  const Ground& ground() const { return *ground_; }

 private:
  std::shared_ptr<const Ground> ground_;
};

}  // namespace groundtruth::exact
