#pragma once
// What a strut finds, told without words. Not installed.

#include <optional>
#include <string>

#include <groundtruth/fast/range_ends.hpp>
#include <groundtruth/fast/scene.hpp>

namespace groundtruth::fast {

struct QuickTouch {
  enum Kind { nothing, broken, too_steep, surface };

  Kind kind = nothing;
  // Of a surface; no friction: none is known for the tyre.
  const HalfSpace* plane = nullptr;
  const Friction* friction = nullptr;
  std::optional<double> maximum_force{};

  Contact contact(Grip grip, const Vector& pebble_in_world, const Vector& pebble_velocity_in_world) const {
    return {grip,
            pebble_in_world,
            pebble_velocity_in_world,
            plane->normal,
            friction->static_coefficient,
            friction->dynamic_coefficient,
            maximum_force};
  }
};

// Steepness is for others to tell. Nothing: uncertain.
std::optional<QuickTouch> quick_touch(const Scene& scene, const RangeEnds& ends, const std::string& tyre);

}  // namespace groundtruth::fast
