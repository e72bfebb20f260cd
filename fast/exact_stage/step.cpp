#include <groundtruth/fast/exact_stage/step.hpp>

#include <groundtruth/fast/exact_stage/strut.hpp>

namespace groundtruth::fast::exact_stage {

namespace {

Normal<Dyadic> as_dyadics(const Vector& v) { return {v[0], v[1], v[2]}; }

Normal<Dyadic> minus(const Normal<Dyadic>& a, const Normal<Dyadic>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

// Times |q|^2.
struct PebbleInWheel {
  Normal<Dyadic> place;
  Normal<Dyadic> velocity;
};

class Stepper {
 public:
  Stepper(const Scene& scene, Ground& ground, const StepAsk& ask)
      : scene_(scene), ground_(ground), ask_(ask), world_from_wheel_(ask.frame.world_from_wheel) {}

  StepAnswer from_free() const {
    const Touch found = touch(scene_, ground_, ask_, world_from_wheel_, {{}, {}, 1.0, {}});
    const auto* landing = std::get_if<Landing>(&found);
    if (!landing) return no_landing(found, SurdVector{{}, 1.0, {}});
    const auto pebble = nearest_doubles(landing->pebble_in_world, "state.pebble");
    if (const auto* refusal = std::get_if<Refusal>(&pebble)) return *refusal;
    return Stepped{landing->surface.contact(Grip::stick, std::get<Vector>(pebble), {}), {}};
  }

  StepAnswer from(const Contact& contact) const {
    const Wheel& wheel = ask_.wheel;
    const Dyadic& unit = world_from_wheel_.norm_squared();
    const PebbleInWheel pebble = pebble_in_wheel(contact);
    const auto& [p, w] = pebble;
    const Normal<Dyadic> n = world_from_wheel_.to_wheel(as_dyadics(contact.normal_in_world));
    if ((p[2] - unit * wheel.z_max).sign() >= 0) return Stepped{Free{}, {}};
    if ((p[2] - unit * wheel.z_min).sign() <= 0) return StepFailure::wheel_broken;
    if (!is_upright(n, wheel.min_uprightness)) return StepFailure::surface_too_steep;

    const Normal<Dyadic> force{p[0] * wheel.k_xy + w[0] * wheel.d_xy, p[1] * wheel.k_xy + w[1] * wheel.d_xy,
                               (p[2] - unit * wheel.z_zero) * wheel.k_z + w[2] * wheel.d_z};
    const Dyadic pressing = -dot(n, force);  // F'_z |n| |q|^2
    if (pressing.sign() <= 0) return Stepped{Free{}, {}};
    if (contact.maximum_force &&
        (square(pressing) - square(unit * *contact.maximum_force) * dot(n, n)).sign() > 0)
      return StepFailure::surface_gave_way;

    const double friction = contact.grip == Grip::stick ? contact.static_friction : contact.dynamic_friction;
    const ClippedForce clipped = clip_force({n, force, unit, friction, ask_.brake});
    if (clipped.grip == Grip::slip) return slip(contact, pebble, clipped);
    Contact stuck = contact;
    stuck.grip = Grip::stick;
    stuck.pebble_velocity_in_world = {};
    return answer_with(stuck, clipped.force_in_wheel);
  }

 private:
  PebbleInWheel pebble_in_wheel(const Contact& contact) const {
    const Normal<Dyadic> arm =
        minus(as_dyadics(contact.pebble_in_world), as_dyadics(ask_.frame.position_in_world));
    const Normal<Dyadic> turning = cross(as_dyadics(ask_.frame.angular_velocity_in_world), arm);
    const Normal<Dyadic> relative =
        minus(as_dyadics(contact.pebble_velocity_in_world), as_dyadics(ask_.frame.velocity_in_world));
    return {world_from_wheel_.to_wheel(arm), world_from_wheel_.to_wheel(minus(relative, turning))};
  }

  // Where the springs alone, or springs and dampers, give the clipped force.
  PlaceInWheel relocated(const PebbleInWheel& pebble, const ClippedForce& clipped) const {
    const SurdVector& force = clipped.force_in_wheel;
    const Dyadic k_xy(ask_.wheel.k_xy), d_xy(ask_.wheel.d_xy), h(ask_.h);
    if (ask_.wheel.relocation == Relocation::spring)
      return {-force.numerators[0], -force.numerators[1], force.denominator * -k_xy, force.roots};
    const auto damped = [&](std::size_t axis) {
      const Dyadic damping = d_xy * (pebble.place[axis] - h * pebble.velocity[axis]) * clipped.surplus;
      return -(force.numerators[axis] * h + Surd{damping, {}, {}});
    };
    return {damped(0), damped(1), force.denominator * -(h * k_xy + d_xy), force.roots};
  }

  StepAnswer slip(const Contact& contact, const PebbleInWheel& pebble, const ClippedForce& clipped) const {
    const Touch found = touch(scene_, ground_, ask_, world_from_wheel_, relocated(pebble, clipped));
    const auto* landing = std::get_if<Landing>(&found);
    if (!landing) return no_landing(found, clipped.force_in_wheel);
    const SurdVector& place = landing->pebble_in_world;
    SurdVector velocity{place.numerators, place.denominator * ask_.h, place.roots};
    for (std::size_t axis = 0; axis < 3; ++axis)
      velocity.numerators[axis].rational =
          velocity.numerators[axis].rational - place.denominator * contact.pebble_in_world[axis];
    const auto new_pebble = nearest_doubles(place, "state.pebble");
    if (const auto* refusal = std::get_if<Refusal>(&new_pebble)) return *refusal;
    const auto new_velocity = nearest_doubles(velocity, "state.velocity");
    if (const auto* refusal = std::get_if<Refusal>(&new_velocity)) return *refusal;
    return answer_with(
        landing->surface.contact(Grip::slip, std::get<Vector>(new_pebble), std::get<Vector>(new_velocity)),
        clipped.force_in_wheel);
  }

  StepAnswer no_landing(const Touch& found, const SurdVector& force_in_wheel) const {
    if (const auto* failure = std::get_if<StepFailure>(&found)) return *failure;
    if (const auto* refusal = std::get_if<Refusal>(&found)) return *refusal;
    return answer_with(Free{}, force_in_wheel);
  }

  // With the opposite force on the frame.
  StepAnswer answer_with(const WheelState& state, const SurdVector& force_in_wheel) const {
    SurdVector on_frame{world_from_wheel_.to_world(force_in_wheel.numerators),
                        force_in_wheel.denominator * world_from_wheel_.norm_squared(), force_in_wheel.roots};
    for (Surd& component : on_frame.numerators) component = -component;
    const auto force = nearest_doubles(on_frame, "force");
    if (const auto* refusal = std::get_if<Refusal>(&force)) return *refusal;
    return Stepped{state, std::get<Vector>(force)};
  }

  const Scene& scene_;
  Ground& ground_;
  const StepAsk& ask_;
  const WorldFromWheel world_from_wheel_;
};

}  // namespace

StepAnswer step(const Scene& scene, Ground& ground, const StepAsk& ask) {
  const Stepper stepper(scene, ground, ask);
  const auto* contact = std::get_if<Contact>(&ask.state);
  return contact ? stepper.from(*contact) : stepper.from_free();
}

}  // namespace groundtruth::fast::exact_stage
