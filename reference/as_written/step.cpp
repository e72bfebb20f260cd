#include <groundtruth/as_written/clip.hpp>
#include <groundtruth/as_written/contact.hpp>
#include <groundtruth/as_written/step.hpp>
#include <groundtruth/as_written/surface_frame.hpp>
#include <groundtruth/as_written/vector_algebra.hpp>

namespace groundtruth::as_written {
namespace {

Refusal out_of_range(const std::string& quantity) { return {quantity + " leaves the range of doubles"}; }

// The pebble as the wheel frame sees it.
struct Pebble {
  Vector position_in_wheel;
  Vector velocity_in_wheel;
};

Pebble pebble_of(const StepAsk& ask, const Contact& contact, const Placement& placement,
                 const Errata& errata) {
  Vector velocity_in_world = minus(contact.pebble_velocity_in_world, ask.frame.velocity_in_world);
  if (!errata.has(Erratum::frame_rotation_ignored)) {
    const Vector arm_in_world = minus(contact.pebble_in_world, ask.frame.position_in_world);
    velocity_in_world = minus(velocity_in_world, cross(ask.frame.angular_velocity_in_world, arm_in_world));
  }
  return {to_wheel(placement, contact.pebble_in_world), into(placement.world_from_wheel, velocity_in_world)};
}

// The springs' and dampers' force on the pebble.
Vector force_in_wheel(const Wheel& wheel, const Pebble& pebble) {
  const Vector& p = pebble.position_in_wheel;
  const Vector& w = pebble.velocity_in_wheel;
  return {wheel.k_xy * p[0] + wheel.d_xy * w[0], wheel.k_xy * p[1] + wheel.d_xy * w[1],
          wheel.k_z * (p[2] - wheel.z_zero) + wheel.d_z * w[2]};
}

// x or y of the place, in wheel coordinates, to which a pebble slips that bears `clipped` of the force.
double relocated(const StepAsk& ask, double clipped, double position, double velocity, const Errata& errata) {
  const Wheel& wheel = ask.wheel;
  if (wheel.relocation == Relocation::spring || errata.has(Erratum::spring_relocation)) {
    return clipped / wheel.k_xy;
  }
  const double damping = wheel.d_xy / ask.h;
  return (clipped + damping * position - wheel.d_xy * velocity) / (wheel.k_xy + damping);
}

StepAnswer stepped(const WheelState& state, const Vector& force_on_frame_in_world) {
  if (!is_finite(force_on_frame_in_world)) {
    return out_of_range("force");
  }
  if (const Contact* contact = std::get_if<Contact>(&state)) {
    if (!is_finite(contact->pebble_in_world)) {
      return out_of_range("state.pebble");
    }
    if (!is_finite(contact->pebble_velocity_in_world)) {
      return out_of_range("state.velocity");
    }
  }
  return Stepped{state, force_on_frame_in_world};
}

StepAnswer answer_of(const Meeting& meeting, Grip grip, const Vector& velocity_in_world,
                     const Vector& force) {
  if (const Refusal* refusal = std::get_if<Refusal>(&meeting)) {
    return *refusal;
  }
  if (const StepFailure* failure = std::get_if<StepFailure>(&meeting)) {
    return *failure;
  }
  const Contact* met = std::get_if<Contact>(&meeting);
  if (met == nullptr) {
    return stepped(Free{}, force);
  }
  Contact contact = *met;
  contact.grip = grip;
  contact.pebble_velocity_in_world = velocity_in_world;
  return stepped(contact, force);
}

StepAnswer step_from_free(const Scene& scene, const StepAsk& ask, const Errata& errata) {
  const Meeting meeting = meet_ground(scene, ask.wheel, placement_of(ask.frame), 0, 0, errata);
  return answer_of(meeting, Grip::stick, {}, {});
}

StepAnswer stay(const Contact& contact, const Vector& force_on_frame_in_world) {
  Contact stuck = contact;
  stuck.grip = Grip::stick;
  stuck.pebble_velocity_in_world = {};
  return stepped(stuck, force_on_frame_in_world);
}

StepAnswer slip(const Scene& scene, const StepAsk& ask, const Contact& contact, const Placement& placement,
                const Pebble& pebble, const Vector& clipped_in_wheel, const Vector& force_on_frame_in_world,
                const Errata& errata) {
  const auto along = [&](std::size_t axis) {
    return relocated(ask, clipped_in_wheel[axis], pebble.position_in_wheel[axis],
                     pebble.velocity_in_wheel[axis], errata);
  };
  const Meeting meeting = meet_ground(scene, ask.wheel, placement, along(0), along(1), errata);
  Vector velocity_in_world{};
  if (const Contact* met = std::get_if<Contact>(&meeting)) {
    const Vector moved = minus(met->pebble_in_world, contact.pebble_in_world);
    velocity_in_world = {moved[0] / ask.h, moved[1] / ask.h, moved[2] / ask.h};
  }
  return answer_of(meeting, Grip::slip, velocity_in_world, force_on_frame_in_world);
}

StepAnswer step_from_contact(const Scene& scene, const StepAsk& ask, const Contact& contact,
                             const Errata& errata) {
  const Wheel& wheel = ask.wheel;
  const Placement placement = placement_of(ask.frame);
  const Pebble pebble = pebble_of(ask, contact, placement, errata);
  if (!is_finite(pebble.position_in_wheel)) {
    return out_of_range("the pebble's position in wheel coordinates");
  }
  if (pebble.position_in_wheel[2] >= wheel.z_max) {
    return errata.has(Erratum::no_liftoff) ? stay(contact, {}) : stepped(Free{}, {});
  }
  if (pebble.position_in_wheel[2] <= wheel.z_min) {
    return StepFailure::wheel_broken;
  }
  const Vector normal_in_wheel = into(placement.world_from_wheel, scaled_near_one(contact.normal_in_world));
  const auto surface = surface_frame(normal_in_wheel, wheel.min_uprightness, errata);
  if (!surface) {
    return StepFailure::surface_too_steep;
  }
  const Vector force = force_in_wheel(wheel, pebble);
  if (!is_finite(force)) {
    return out_of_range("the force on the pebble");
  }
  const double pressing = dot(surface->z, force);
  if (pressing <= 0 && !errata.has(Erratum::tensile_contact)) {
    return stepped(Free{}, {});
  }
  if (contact.maximum_force && pressing > *contact.maximum_force) {
    return StepFailure::surface_gave_way;
  }
  const double friction = contact.grip == Grip::stick ? contact.static_friction : contact.dynamic_friction;
  const ClipAnswer answer =
      clip({force, normal_in_wheel, friction, ask.brake, wheel.min_uprightness}, errata);
  if (const Refusal* refusal = std::get_if<Refusal>(&answer)) {
    return *refusal;
  }
  const Clipped& clipped = std::get<Clipped>(answer);
  const Vector on_pebble_in_world = out_of(placement.world_from_wheel, clipped.force_in_wheel);
  const Vector on_frame_in_world =
      errata.has(Erratum::force_on_frame_sign) ? on_pebble_in_world : times(-1, on_pebble_in_world);
  if (clipped.grip == Grip::stick) {
    return stay(contact, on_frame_in_world);
  }
  return slip(scene, ask, contact, placement, pebble, clipped.force_in_wheel, on_frame_in_world, errata);
}

}  // namespace

StepAnswer step(const Scene& scene, const StepAsk& ask, const Errata& errata) {
  if (const Contact* contact = std::get_if<Contact>(&ask.state)) {
    return step_from_contact(scene, ask, *contact, errata);
  }
  return step_from_free(scene, ask, errata);
}

}  // namespace groundtruth::as_written
