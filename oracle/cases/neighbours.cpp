#include <cmath>
#include <variant>

#include <groundtruth/cases/neighbours.hpp>

namespace groundtruth::cases {
namespace {

double next_size(double size, Random& random) { return std::abs(one_ulp_off(size, random)); }

}  // namespace

EntryAsk neighbour(const EntryAsk& ask, Random& random) {
  EntryAsk result = ask;
  result.from = one_ulp_off(ask.from, random);
  // A segment that is a point stays one.
  result.to = ask.from == ask.to ? result.from : one_ulp_off(ask.to, random);
  return result;
}

ClipAsk neighbour(const ClipAsk& ask, Random& random) {
  ClipAsk result = ask;
  result.force_in_wheel = one_ulp_off(ask.force_in_wheel, random);
  if (random.one_in(2)) result.normal_in_wheel = one_ulp_off(ask.normal_in_wheel, random);
  result.friction = next_size(ask.friction, random);
  result.brake = next_size(ask.brake, random);
  return result;
}

StepAsk neighbour(const StepAsk& ask, Random& random) {
  StepAsk result = ask;
  result.frame.position_in_world = one_ulp_off(ask.frame.position_in_world, random);
  result.brake = next_size(ask.brake, random);
  if (auto* contact = std::get_if<Contact>(&result.state)) {
    contact->pebble_in_world = one_ulp_off(contact->pebble_in_world, random);
    if (random.one_in(2)) contact->normal_in_world = one_ulp_off(contact->normal_in_world, random);
    contact->static_friction = next_size(contact->static_friction, random);
    contact->dynamic_friction = next_size(contact->dynamic_friction, random);
    if (contact->maximum_force) contact->maximum_force = next_size(*contact->maximum_force, random);
  }
  return result;
}

}  // namespace groundtruth::cases
