#include <groundtruth/as_written/contact.hpp>
#include <groundtruth/as_written/entry_point.hpp>
#include <groundtruth/as_written/segment.hpp>
#include <groundtruth/as_written/surface_frame.hpp>

namespace groundtruth::as_written {
namespace {

Axes world_from_wheel(const Quaternion& quaternion) {
  const auto [w, x, y, z] = scaled_near_one(quaternion);
  const double norm = (w * w + x * x) + (y * y + z * z);
  return {
      {((w * w + x * x) - (y * y + z * z)) / norm, 2 * (x * y + w * z) / norm, 2 * (x * z - w * y) / norm},
      {2 * (x * y - w * z) / norm, ((w * w + y * y) - (x * x + z * z)) / norm, 2 * (y * z + w * x) / norm},
      {2 * (x * z + w * y) / norm, 2 * (y * z - w * x) / norm, ((w * w + z * z) - (x * x + y * y)) / norm}};
}

Meeting contact_on(const Scene& scene, const Border& border, const Vector& pebble_in_world,
                   const std::string& tyre) {
  const std::string leaf = "contact: leaf " + std::to_string(border.leaf);
  if (!border.material) {
    return Refusal{leaf + " has no material"};
  }
  const Material& material = scene.material(*border.material);
  const auto friction = material.friction_by_tyre.find(tyre);
  if (friction == material.friction_by_tyre.end()) {
    return Refusal{leaf + ": material '" + material.name + "' has no friction for '" + tyre + "'"};
  }
  Contact contact;
  contact.pebble_in_world = pebble_in_world;
  contact.normal_in_world = border.normal_in_world;
  contact.static_friction = friction->second.static_coefficient;
  contact.dynamic_friction = friction->second.dynamic_coefficient;
  contact.maximum_force = material.maximum_force;
  return contact;
}

}  // namespace

Placement placement_of(const Frame& frame) {
  return {frame.position_in_world, world_from_wheel(frame.world_from_wheel)};
}

Vector to_world(const Placement& placement, const Vector& point_in_wheel) {
  return plus(placement.position_in_world, out_of(placement.world_from_wheel, point_in_wheel));
}

Vector to_wheel(const Placement& placement, const Vector& point_in_world) {
  return into(placement.world_from_wheel, minus(point_in_world, placement.position_in_world));
}

Meeting meet_ground(const Scene& scene, const Wheel& wheel, const Placement& placement, double x, double y,
                    const Errata& errata) {
  const EntryAsk suspension{to_world(placement, {x, y, wheel.z_min}),
                            to_world(placement, {x, y, wheel.z_max})};
  if (!is_finite(suspension.from) || !is_finite(suspension.to)) {
    return Refusal{"an end of the suspension leaves the range of doubles"};
  }
  const EntryAnswer entry = entry_point(scene, suspension, errata);
  if (std::holds_alternative<Inside>(entry)) {
    return StepFailure::wheel_broken;
  }
  const Border* border = std::get_if<Border>(&entry);
  if (border == nullptr || border->lambda == 1) {
    return Free{};
  }
  if (border->lambda == 0) {
    return StepFailure::wheel_broken;
  }
  const Vector normal_in_wheel = into(placement.world_from_wheel, scaled_near_one(border->normal_in_world));
  if (!surface_frame(normal_in_wheel, wheel.min_uprightness, errata)) {
    return StepFailure::surface_too_steep;
  }
  return contact_on(scene, *border, Segment(suspension).at(border->lambda), wheel.tyre);
}

}  // namespace groundtruth::as_written
