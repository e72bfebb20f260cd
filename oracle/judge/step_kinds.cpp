#include "step_kinds.hpp"

#include <cmath>

#include "spread.hpp"

namespace groundtruth::judge {
namespace {

bool are_close(double got, double expected, double relative) {
  return std::fabs(static_cast<long double>(got) - expected) <= allowed(relative, std::fabs(expected));
}

}  // namespace

const Contact* contact_in(const StepAnswer& answer) {
  const auto* stepped = std::get_if<Stepped>(&answer);
  return stepped == nullptr ? nullptr : std::get_if<Contact>(&stepped->state);
}

bool are_of_one_kind(const StepAnswer& a, const StepAnswer& b) {
  if (a.index() != b.index()) return false;
  if (const auto* failure = std::get_if<StepFailure>(&a)) return *failure == std::get<StepFailure>(b);
  const Contact* in_a = contact_in(a);
  const Contact* in_b = contact_in(b);
  if ((in_a == nullptr) != (in_b == nullptr)) return false;
  return in_a == nullptr || in_a->grip == in_b->grip;
}

bool has_friction_of(const Contact& got, const Contact& expected, double relative) {
  const bool limits =
      got.maximum_force.has_value() == expected.maximum_force.has_value() &&
      (!got.maximum_force || are_close(*got.maximum_force, *expected.maximum_force, relative));
  return limits && are_close(got.static_friction, expected.static_friction, relative) &&
         are_close(got.dynamic_friction, expected.dynamic_friction, relative);
}

std::optional<Contact> contact_of(const Scene& scene, const MaterialOrNone& material,
                                  const std::string& tyre) {
  if (!material) return std::nullopt;
  const Material& of = scene.materials[*material];
  const auto friction = of.friction_by_tyre.find(tyre);
  if (friction == of.friction_by_tyre.end()) return std::nullopt;
  Contact contact;
  contact.static_friction = friction->second.static_coefficient;
  contact.dynamic_friction = friction->second.dynamic_coefficient;
  contact.maximum_force = of.maximum_force;
  return contact;
}

}  // namespace groundtruth::judge
