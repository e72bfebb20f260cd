#pragma once
// What a wheel that touches the ground finds there. Not installed.

#include <optional>
#include <string>
#include <variant>

#include <groundtruth/fast/scene.hpp>
#include <groundtruth/problem/answer.hpp>

namespace groundtruth::fast {

// A wheel's free end.
struct NoContact {};

struct Surface {
  Vector normal_in_world;
  Friction friction;
  std::optional<double> maximum_force;

  Contact contact(Grip grip, const Vector& pebble_in_world, const Vector& pebble_velocity_in_world) const {
    return {grip,
            pebble_in_world,
            pebble_velocity_in_world,
            normal_in_world,
            friction.static_coefficient,
            friction.dynamic_coefficient,
            maximum_force};
  }
};

// Refuses a leaf without material, or without friction for the tyre, by a reason that names them.
inline std::variant<Surface, Refusal> surface_of(const Scene& scene, Leaf leaf, const Vector& normal_in_world,
                                                 std::optional<MaterialIndex> material,
                                                 const std::string& tyre) {
  const auto refusal = [&](const std::string& why) {
    return Refusal{"contact: leaf " + std::to_string(leaf) + why};
  };
  if (!material) return refusal(" has no material");
  const Material& found = scene.materials()[*material];
  const auto friction = found.friction_by_tyre.find(tyre);
  if (friction == found.friction_by_tyre.end())
    return refusal(": material '" + found.name + "' has no friction for '" + tyre + "'");
  return Surface{normal_in_world, friction->second, found.maximum_force};
}

}  // namespace groundtruth::fast
