#include <groundtruth/exact/wheel/landing.hpp>

#include <groundtruth/exact/wheel/clipping.hpp>

namespace groundtruth::exact {
namespace {

Touch contact_with(const Ground& ground, const Wheel& wheel, const Entry<RootSum>& entry) {
  const Leaf leaf = entry.admissible.front();
  const auto index = material_at(ground, leaf, entry.point);
  const std::string where = "contact: leaf " + std::to_string(leaf);
  if (!index) return Refusal{where + " has no material"};
  const Material& material = ground.materials[*index];
  const auto friction = material.friction_by_tyre.find(wheel.tyre);
  if (friction == material.friction_by_tyre.end()) {
    return Refusal{where + ": material '" + material.name + "' has no friction for '" + wheel.tyre + "'"};
  }
  Contact contact;
  contact.normal_in_world = ground.solid.half_spaces[leaf].normal;
  contact.static_friction = friction->second.static_coefficient;
  contact.dynamic_friction = friction->second.dynamic_coefficient;
  contact.maximum_force = material.maximum_force;
  return Landing{entry.point, contact};
}

}  // namespace

Touch touch_down(const Ground& ground, const Wheel& wheel, const Placement& placement,
                 const RootVector& top_in_world) {
  const RationalVector strut(0, 0, Rational(wheel.z_max) - Rational(wheel.z_min));
  const Segment<RootSum> segment{top_in_world.components(), placement.world_from_wheel(strut)};
  const auto entry = find_entry(ground.solid, segment);
  if (!entry || sign(entry->lambda - RootSum(segment.last)) == 0) return Clear{};
  if (sign(entry->lambda) == 0) return StepFailure::wheel_broken;
  const RationalVector normal_in_world =
      to_rational(ground.solid.half_spaces[entry->admissible.front()].normal);
  if (!is_upright(placement.world_from_wheel.inverse(normal_in_world), Rational(wheel.min_uprightness))) {
    return StepFailure::surface_too_steep;
  }
  return contact_with(ground, wheel, *entry);
}

}  // namespace groundtruth::exact
