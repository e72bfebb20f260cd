#include <groundtruth/cases/ask_changes.hpp>

#include <utility>
#include <variant>

#include <groundtruth/cases/vector_arithmetic.hpp>

#include "number_changes.hpp"

namespace groundtruth::cases {
namespace {

Contact changed_contact(Contact contact, Random& random) {
  switch (random.below(8)) {
    case 0:
      contact.grip = contact.grip == Grip::stick ? Grip::slip : Grip::stick;
      return contact;
    case 1:
      std::swap(contact.static_friction, contact.dynamic_friction);
      return contact;
    case 2:
      contact.static_friction = changed_size(contact.static_friction, random);
      return contact;
    case 3:
      contact.dynamic_friction = changed_size(contact.dynamic_friction, random);
      return contact;
    case 4:
      contact.pebble_velocity_in_world = changed_vector(contact.pebble_velocity_in_world, random);
      return contact;
    case 5:
      contact.normal_in_world = changed_vector(contact.normal_in_world, random);
      return contact;
    case 6:
      if (contact.maximum_force) contact.maximum_force = changed_size(*contact.maximum_force, random);
      return contact;
    default:
      contact.pebble_in_world = changed_vector(contact.pebble_in_world, random);
      return contact;
  }
}

Quaternion changed_orientation(Quaternion orientation, Random& random) {
  const Quaternion before = orientation;
  const std::size_t place = random.below(4);
  if (random.one_in(3)) {
    for (double& number : orientation) number *= 2;
  } else {
    orientation[place] = changed_number(orientation[place], random);
  }
  return orientation == Quaternion{} ? before : orientation;
}

Frame changed_frame(Frame frame, Random& random) {
  switch (random.below(5)) {
    case 0:
      frame.world_from_wheel = changed_orientation(frame.world_from_wheel, random);
      return frame;
    case 1:
      frame.velocity_in_world = changed_vector(frame.velocity_in_world, random);
      return frame;
    case 2:
      frame.angular_velocity_in_world = changed_vector(frame.angular_velocity_in_world, random);
      return frame;
    default:
      frame.position_in_world = changed_vector(frame.position_in_world, random);
      return frame;
  }
}

Wheel changed_wheel(Wheel wheel, Random& random) {
  switch (random.below(7)) {
    case 0:
      wheel.relocation =
          wheel.relocation == Relocation::spring ? Relocation::return_mapping : Relocation::spring;
      return wheel;
    case 1:
      wheel.k_xy = -changed_positive(-wheel.k_xy, random);
      return wheel;
    case 2:
      wheel.k_z = -changed_positive(-wheel.k_z, random);
      return wheel;
    case 3:
      wheel.d_xy = 0 - changed_size(wheel.d_xy, random);
      return wheel;
    case 4:
      wheel.d_z = 0 - changed_size(wheel.d_z, random);
      return wheel;
    case 5:
      wheel.z_zero = wheel.z_max;
      return wheel;
    default:
      wheel.min_uprightness = changed_positive(wheel.min_uprightness, random);
      return wheel;
  }
}

// All offsets of one contact from its frame stay: everything moves in the world.
StepAsk moved(StepAsk ask, Random& random) {
  const double far = std::ldexp(1.0, static_cast<int>(random.between(0, 30)));
  const Vector offset{random.sign() * far, random.sign() * far, 0};
  ask.frame.position_in_world = plus(ask.frame.position_in_world, offset);
  if (auto* contact = std::get_if<Contact>(&ask.state)) {
    contact->pebble_in_world = plus(contact->pebble_in_world, offset);
  }
  return ask;
}

bool are_loads(const StepAsk& ask) {
  const Wheel& wheel = ask.wheel;
  return std::isfinite(wheel.k_xy + wheel.k_z + wheel.d_xy + wheel.d_z) && std::isfinite(ask.brake) &&
         wheel.k_xy < 0 && wheel.k_z < 0;
}

// Everything that is measured in newtons, larger or smaller.
StepAsk at_other_load(const StepAsk& ask, Random& random) {
  const double scale = std::ldexp(1.0, static_cast<int>(random.between(-30, 30)));
  StepAsk result = ask;
  Wheel& wheel = result.wheel;
  for (double* number : {&wheel.k_xy, &wheel.k_z, &wheel.d_xy, &wheel.d_z, &result.brake}) *number *= scale;
  return are_loads(result) ? result : ask;
}

}  // namespace

ClipAsk changed(const ClipAsk& ask, Random& random) {
  ClipAsk result = ask;
  switch (random.below(7)) {
    case 0:
      result.brake = changed_size(ask.brake, random);
      break;
    case 1:
      result.friction = changed_size(ask.friction, random);
      break;
    case 2:
      result.normal_in_wheel = changed_vector(ask.normal_in_wheel, random);
      break;
    case 3: {  // B = mu N, where the normal is upright
      const double widest = std::abs(ask.friction * ask.force_in_wheel[2]);
      if (std::isfinite(widest)) result.brake = widest;
      break;
    }
    case 4:
      result.min_uprightness = changed_positive(ask.min_uprightness, random);
      break;
    default:
      result.force_in_wheel = changed_vector(ask.force_in_wheel, random);
  }
  return result;
}

StepAsk changed(const StepAsk& ask, Random& random) {
  StepAsk result = ask;
  switch (random.below(9)) {
    case 0:
      result.brake = changed_size(ask.brake, random);
      break;
    case 1:
      result.h = changed_positive(ask.h, random);
      break;
    case 2:
    case 3:
      result.frame = changed_frame(ask.frame, random);
      break;
    case 4:
      result.wheel = changed_wheel(ask.wheel, random);
      break;
    case 5:
      result = moved(ask, random);
      break;
    case 6:
      result = at_other_load(ask, random);
      break;
    default:
      if (const auto* contact = std::get_if<Contact>(&ask.state)) {
        result.state = changed_contact(*contact, random);
      } else {
        result.frame = changed_frame(ask.frame, random);
      }
  }
  return result;
}

}  // namespace groundtruth::cases
