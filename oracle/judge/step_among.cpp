#include <algorithm>
#include <limits>

#include "direction.hpp"
#include "spread.hpp"
#include "step_kinds.hpp"
#include "step_match.hpp"

namespace groundtruth::judge {
namespace {

// The vectors of one kind of all these answers.
template <typename Select>
Spread spread_of(const std::vector<const Contact*>& contacts, const Select& select) {
  Spread spread(select(*contacts.front()));
  for (const Contact* contact : contacts) spread.include(select(*contact));
  return spread;
}

double finite(long double value) {
  return static_cast<double>(std::min(value, static_cast<long double>(std::numeric_limits<double>::max())));
}

Contact with_normal(Contact contact, const Vector& normal) {
  contact.normal_in_world = normal;
  return contact;
}

}  // namespace

bool StepMatch::lies_among(const StepAnswer& got, const std::vector<StepAnswer>& explanations) const {
  std::vector<const StepAnswer*> same;
  for (const StepAnswer& explanation : explanations) {
    if (are_of_one_kind(got, explanation)) same.push_back(&explanation);
  }
  if (same.empty()) return false;
  const auto* stepped = std::get_if<Stepped>(&got);
  if (stepped == nullptr) return true;
  Spread forces(std::get<Stepped>(*same.front()).force_on_frame_in_world);
  std::vector<const Contact*> contacts;
  for (const StepAnswer* answer : same) {
    forces.include(std::get<Stepped>(*answer).force_on_frame_in_world);
    if (const Contact* contact = contact_in(*answer)) contacts.push_back(contact);
  }
  const Tolerance& tolerance = truth_.tolerance();
  const long double slack =
      allowed(tolerance.relative_number, scales_.clipped) + 4 * tolerance.relative_decision * scales_.force;
  if (forces.distance_to(stepped->force_on_frame_in_world) > slack) return false;
  const Contact* contact = contact_in(got);
  return contact == nullptr || is_contact_among(*contact, contacts);
}

bool StepMatch::is_contact_among(const Contact& got, const std::vector<const Contact*>& expected) const {
  const Tolerance& tolerance = truth_.tolerance();
  const Spread pebbles = spread_of(expected, [](const Contact& contact) { return contact.pebble_in_world; });
  const Spread velocities =
      spread_of(expected, [](const Contact& contact) { return contact.pebble_velocity_in_world; });
  long double slack = is_kept(got) ? kept_slack() : 0;
  for (const Contact* contact : expected) {
    if (is_kept(got)) break;
    const long double moved = 4 * tolerance.relative_decision * scales_.force / scales_.stiffness *
                              amplification(contact->normal_in_world, ask_.frame);
    slack = std::max(slack, landing_slack(*contact) + moved);
  }
  if (pebbles.distance_to(got.pebble_in_world) > slack) return false;
  const bool sticks = got.grip == Grip::stick;
  const long double velocity_slack =
      sticks ? 0 : allowed(tolerance.relative_number, scales_.velocity) + slack / ask_.h;
  if (velocities.distance_to(got.pebble_velocity_in_world) > velocity_slack) return false;
  const auto has_its_face = [&](const Contact* contact) { return has_face_of(got, *contact); };
  return std::any_of(expected.begin(), expected.end(), has_its_face) ||
         (!is_kept(got) && tolerance.faces == Faces::any_admissible && has_face_nearby(got, slack));
}

bool StepMatch::has_face_of(const Contact& got, const Contact& expected) const {
  const Tolerance& tolerance = truth_.tolerance();
  return points_along(got.normal_in_world, expected.normal_in_world, tolerance.normal_angle) &&
         has_friction_of(got, expected, tolerance.relative_number);
}

// Whether a leaf passes within this distance of the pebble, with such a normal and friction there.
bool StepMatch::has_face_nearby(const Contact& got, long double distance) const {
  const Scene& scene = truth_.scene();
  const Around around{rational(got.pebble_in_world), finite(distance)};
  const Rational reach = rational(around.radius);
  for (Leaf leaf = 0; leaf < truth_.leaves().size(); ++leaf) {
    const HalfSpace& plane = truth_.leaves()[leaf];
    const RationalVector normal = rational(plane.normal);
    const Rational height = dot(normal, around.point_in_world) - rational(plane.offset);
    if (height * height > reach * reach * dot(normal, normal)) continue;
    for (const MaterialOrNone& material : materials_of(scene.shape, leaf, around)) {
      const std::optional<Contact> made = contact_of(scene, material, ask_.wheel.tyre);
      if (made && has_face_of(got, with_normal(*made, plane.normal))) return true;
    }
  }
  return false;
}

bool StepMatch::is_kept(const Contact& got) const {
  return got.grip == Grip::stick && std::holds_alternative<Contact>(ask_.state);
}

}  // namespace groundtruth::judge
