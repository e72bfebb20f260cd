#include "plain_step.hpp"

namespace groundtruth::planted {

StepAnswer PlainStep::take() const {
  if (const auto* contact = std::get_if<Contact>(&ask.state)) return from(*contact);
  const Touch touched = touch({0, 0});
  if (std::holds_alternative<Clear>(touched)) return no_contact();
  const auto* landed = std::get_if<Contact>(&touched);
  return landed ? first_contact(*landed) : failure_of(touched);
}

StepAnswer PlainStep::from(const Contact& contact) const {
  const Seen in_wheel = seen(contact);
  if (const auto limit = at_limits(in_wheel, contact)) return *limit;
  if (!is_upright(in_wheel.normal)) return StepFailure::surface_too_steep;
  const Numbers force = spring_force(in_wheel);
  const Number pressure = -dot(force, in_wheel.normal) / length(in_wheel.normal);
  if (const auto end = under_pressure(pressure, force, contact)) return *end;
  const auto clipped = PlainClip().clip(force, in_wheel.normal, friction(contact), brake(contact));
  const Vector on_frame = force_on_frame(clipped.force_in_wheel);
  if (clipped.grip == Grip::stick) return stay(contact, on_frame);
  return slide(contact, touch(relocated(in_wheel, clipped.force_in_wheel)), on_frame);
}

Seen PlainStep::seen(const Contact& contact) const {
  const Numbers turning = cross(numbers(ask.frame.angular_velocity_in_world), arm(contact));
  const Numbers velocity =
      numbers(contact.pebble_velocity_in_world) - numbers(ask.frame.velocity_in_world) - turning;
  return {world_from_wheel.inverse(arm(contact)), world_from_wheel.inverse(velocity),
          world_from_wheel.inverse(numbers(contact.normal_in_world))};
}

std::optional<StepAnswer> PlainStep::at_limits(const Seen& in_wheel, const Contact&) const {
  if (compare(in_wheel.pebble[2], wheel.z_max) >= 0) return no_contact();
  if (compare(in_wheel.pebble[2], wheel.z_min) <= 0) return StepFailure::wheel_broken;
  return std::nullopt;
}

bool PlainStep::is_upright(const Numbers& normal) const {
  return PlainClip().is_upright(normal, wheel.min_uprightness);
}

Numbers PlainStep::spring_force(const Seen& in_wheel) const {
  const auto& [p, w, n] = in_wheel;
  return {wheel.k_xy * p[0] + wheel.d_xy * w[0], wheel.k_xy * p[1] + wheel.d_xy * w[1],
          wheel.k_z * (p[2] - wheel.z_zero) + wheel.d_z * w[2]};
}

std::optional<StepAnswer> PlainStep::under_pressure(const Number& pressure, const Numbers& force,
                                                    const Contact& contact) const {
  if (compare(pressure, 0, length(force)) <= 0) return no_contact();
  if (contact.maximum_force && compare(pressure, *contact.maximum_force) > 0) {
    return StepFailure::surface_gave_way;
  }
  return std::nullopt;
}

Number PlainStep::friction(const Contact& contact) const {
  return contact.grip == Grip::stick ? contact.static_friction : contact.dynamic_friction;
}

Number PlainStep::brake(const Contact&) const { return ask.brake; }

Vector PlainStep::force_on_frame(const Numbers& clipped) const {
  return doubles(Number(-1) * world_from_wheel(clipped));
}

StepAnswer PlainStep::stay(const Contact& contact, const Vector& force) const {
  Contact stuck = contact;
  stuck.grip = Grip::stick;
  stuck.pebble_velocity_in_world = {};
  return Stepped{stuck, force};
}

Level PlainStep::relocated(const Seen& in_wheel, const Numbers& clipped) const {
  if (wheel.relocation == Relocation::spring) return {clipped[0] / wheel.k_xy, clipped[1] / wheel.k_xy};
  const Number rate = Number(wheel.d_xy) / ask.h;
  const auto mapped = [&](std::size_t i) {
    return Number((clipped[i] + rate * in_wheel.pebble[i] - wheel.d_xy * in_wheel.velocity[i]) /
                  (wheel.k_xy + rate));
  };
  return {mapped(0), mapped(1)};
}

StepAnswer PlainStep::slide(const Contact& contact, const Touch& touched, const Vector& force) const {
  if (std::holds_alternative<Clear>(touched)) return no_contact(force);
  const auto* landed = std::get_if<Contact>(&touched);
  return landed ? Stepped{slid(contact, *landed), force} : failure_of(touched);
}

Contact PlainStep::slid(const Contact& before, Contact landed) const {
  const Numbers way = numbers(landed.pebble_in_world) - numbers(before.pebble_in_world);
  landed.grip = Grip::slip;
  landed.pebble_velocity_in_world = doubles((Number(1) / ask.h) * way);
  return landed;
}

EntryAsk PlainStep::strut(const Level& level) const {
  return {doubles(to_world({level.x, level.y, wheel.z_min})),
          doubles(to_world({level.x, level.y, wheel.z_max})), 0, 1};
}

Touch PlainStep::touch(const Level& level) const {
  const EntryAsk asked = strut(level);
  if (!is_finite(asked.from) || !is_finite(asked.to)) return Refusal{"the strut leaves the range of doubles"};
  const EntryAnswer entry = right.entry(asked);
  if (std::holds_alternative<Miss>(entry)) return Clear{};
  if (is_start(entry)) return StepFailure::wheel_broken;
  const auto* border = std::get_if<Border>(&entry);
  if (border == nullptr || is_end(border->lambda)) return Clear{};
  if (!is_landing_upright(world_from_wheel.inverse(numbers(border->normal_in_world)))) {
    return StepFailure::surface_too_steep;
  }
  Touch touched = contact_on(*border);
  if (auto* contact = std::get_if<Contact>(&touched)) {
    const Numbers from = numbers(asked.from);
    contact->pebble_in_world = doubles(from + Number(border->lambda) * (numbers(asked.to) - from));
  }
  return touched;
}

bool PlainStep::is_start(const EntryAnswer& entry) const {
  const auto* border = std::get_if<Border>(&entry);
  return border == nullptr || border->lambda == 0;
}

bool PlainStep::is_landing_upright(const Numbers& normal) const { return PlainStep::is_upright(normal); }

Touch PlainStep::contact_on(const Border& border) const {
  if (!border.material) return Refusal{"contact: no material"};
  const Material& material = right.scene().materials[*border.material];
  const auto friction = material.friction_by_tyre.find(wheel.tyre);
  if (friction == material.friction_by_tyre.end()) return Refusal{"contact: no friction for this tyre"};
  Contact contact;
  contact.normal_in_world = border.normal_in_world;
  contact.static_friction = friction->second.static_coefficient;
  contact.dynamic_friction = friction->second.dynamic_coefficient;
  contact.maximum_force = material.maximum_force;
  return contact;
}

StepAnswer PlainStep::first_contact(Contact contact) const {
  contact.grip = Grip::stick;
  return Stepped{contact, Vector{}};
}

StepAnswer PlainStep::failure_of(const Touch& touched) {
  if (const auto* failure = std::get_if<StepFailure>(&touched)) return *failure;
  return std::get<Refusal>(touched);
}

namespace {

bool is_finite_answer(const StepAnswer& answer) {
  const auto* stepped = std::get_if<Stepped>(&answer);
  if (stepped == nullptr) return true;
  const auto* contact = std::get_if<Contact>(&stepped->state);
  return is_finite(stepped->force_on_frame_in_world) &&
         (contact == nullptr ||
          (is_finite(contact->pebble_in_world) && is_finite(contact->pebble_velocity_in_world)));
}

}  // namespace

StepAnswer deviation(const Right& right, const StepAsk& ask, const PlainStep& wrong) {
  const StepAnswer answer = wrong.take();
  const bool deviates = answer != PlainStep(ask, right).take() && is_finite_answer(answer);
  return deviates ? answer : right.step(ask);
}

}  // namespace groundtruth::planted
