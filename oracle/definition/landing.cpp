#include <groundtruth/definition/faces.hpp>
#include <groundtruth/definition/landing.hpp>
#include <groundtruth/definition/refused.hpp>
#include <groundtruth/definition/surface.hpp>

namespace groundtruth::definition {
namespace {

const Material& contact_material(const PreparedScene& scene, Leaf leaf, const Point& point) {
  const std::optional<MaterialIndex> material = material_at(scene.solid, leaf, point);
  if (!material) throw Refused("contact: leaf " + std::to_string(leaf) + " has no material");
  return scene.materials[*material];
}

const Friction& contact_friction(const Material& material, const std::string& tyre, Leaf leaf) {
  const auto friction = material.friction_by_tyre.find(tyre);
  if (friction == material.friction_by_tyre.end())
    throw Refused("contact: leaf " + std::to_string(leaf) + ": material '" + material.name +
                  "' has no friction for '" + tyre + "'");
  return friction->second;
}

Triple<Real> exact_position(const Point& point) {
  return {quotient(point.numerators[0], point.weight), quotient(point.numerators[1], point.weight),
          quotient(point.numerators[2], point.weight)};
}

}  // namespace

Landing landing(const PreparedScene& scene, const WheelFrame& frame, const Wheel& wheel,
                const Real& x_in_wheel, const Real& y_in_wheel) {
  const auto leg_end = [&](double z_in_wheel) {
    return frame.world_from_wheel_point({x_in_wheel, y_in_wheel, rational(z_in_wheel)});
  };
  const Segment leg = segment_between(leg_end(wheel.z_min), leg_end(wheel.z_max));
  const std::optional<Moment> moment = first_member(scene.solid, leg);
  if (!moment || moment->is_end()) return NoGround{};
  if (moment->is_start()) return StepFailure::wheel_broken;

  const Leaf leaf = faces_at(scene.solid, leg, *moment).admissible.front();
  const Vector& normal_in_world = scene.solid.half_spaces[leaf].normal_as_written;
  const Triple<Rational> normal_in_wheel = frame.wheel_from_world_direction(rational(normal_in_world));
  if (is_too_steep(normal_in_wheel, rational(wheel.min_uprightness))) return StepFailure::surface_too_steep;

  const Point point = point_at(leg, *moment);
  const Material& material = contact_material(scene, leaf, point);
  const Friction& friction = contact_friction(material, wheel.tyre, leaf);
  return Ground{exact_position(point), normal_in_world, friction, material.maximum_force};
}

}  // namespace groundtruth::definition
