#pragma once
// A scene made ready to be asked by the second witness.

#include <memory>

#include <groundtruth/problem/scene.hpp>

namespace groundtruth::definition {

struct PreparedScene;

// Written once, then only read: several threads may ask at once. A copy shares the preparation.
class Scene {
 public:
  // Requires finite numbers, and operands that are there (`over`, `where` not null).
  explicit Scene(const groundtruth::Scene& scene);

  const PreparedScene& prepared() const { return *prepared_; }

 private:
  std::shared_ptr<const PreparedScene> prepared_;
};

}  // namespace groundtruth::definition
