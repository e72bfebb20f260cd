#pragma once
// What a strut finds, told without words. Not installed.

#include <optional>
#include <string>

#include <groundtruth/fast/range_ends.hpp>
#include <groundtruth/fast/scene.hpp>

namespace groundtruth::fast {

struct QuickTouch {
  enum Kind { uncertain, nothing, broken, too_steep, surface };

  Kind kind = uncertain;
  // Of a surface; no friction: none is known for the tyre.
  HalfSpace plane{};
  const Friction* friction = nullptr;
  std::optional<double> maximum_force{};

  void write(Contact& contact) const {
    contact.normal_in_world = plane.normal;
    contact.static_friction = friction->static_coefficient;
    contact.dynamic_friction = friction->dynamic_coefficient;
    contact.maximum_force = maximum_force;
  }
};

// Steepness is for others to tell. In place: a processor waits where what was just written is copied.
void quick_touch(const Scene& scene, const RangeEnds& ends, const std::string& tyre, QuickTouch& touch);

}  // namespace groundtruth::fast
