#pragma once
// For tests that look at the solid as written.

#include <groundtruth/fast/scene.hpp>

namespace groundtruth::fast {

inline Scene compile_with_solid(const groundtruth::Scene& scene) {
  return compile(scene, CompileOptions().leave_off(Simplification::written_solid));
}

}  // namespace groundtruth::fast
