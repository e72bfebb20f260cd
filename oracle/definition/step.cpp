#include <groundtruth/definition/force_clip.hpp>
#include <groundtruth/definition/landing.hpp>
#include <groundtruth/definition/refused.hpp>
#include <groundtruth/definition/step.hpp>

namespace groundtruth::definition {
namespace {

constexpr Vector no_force{};

Contact contact_on(const Ground& ground, Grip grip, const Triple<Real>& velocity_in_world) {
  return {grip,
          rounded(ground.point_in_world, "state.pebble"),
          rounded(velocity_in_world, "state.velocity"),
          ground.normal_in_world,
          ground.friction.static_coefficient,
          ground.friction.dynamic_coefficient,
          ground.maximum_force};
}

StepAnswer step_from_free(const PreparedScene& scene, const StepAsk& ask) {
  const Landing found = landing(scene, WheelFrame(ask.frame), ask.wheel, 0, 0);
  if (const auto* failure = std::get_if<StepFailure>(&found)) return *failure;
  if (const auto* ground = std::get_if<Ground>(&found))
    return Stepped{contact_on(*ground, Grip::stick, {0, 0, 0}), no_force};
  return Stepped{Free{}, no_force};
}

// One step of a wheel whose pebble lies on the ground.
class ContactStep {
 public:
  ContactStep(const PreparedScene& scene, const StepAsk& ask, const Contact& contact)
      : scene_(scene),
        ask_(ask),
        contact_(contact),
        frame_(ask.frame),
        pebble_in_world_(rational(contact.pebble_in_world)),
        pebble_in_wheel_(frame_.wheel_from_world_point(pebble_in_world_)),
        velocity_in_wheel_(frame_.wheel_from_world_direction(rational(contact.pebble_velocity_in_world) -
                                                             frame_.velocity_in_world(pebble_in_world_))) {}

  StepAnswer answer() const {
    const Wheel& wheel = ask_.wheel;
    if (pebble_in_wheel_[2] >= rational(wheel.z_max)) return Stepped{Free{}, no_force};
    if (pebble_in_wheel_[2] <= rational(wheel.z_min)) return StepFailure::wheel_broken;
    const Triple<Rational> normal = frame_.wheel_from_world_direction(rational(contact_.normal_in_world));
    if (is_too_steep(normal, rational(wheel.min_uprightness))) return StepFailure::surface_too_steep;

    const Surface surface(normal);
    const Triple<Rational> force = spring_force();
    const Real pressing = surface.surface_from_wheel(real(force))[2];
    if (pressing.sign() <= 0) return Stepped{Free{}, no_force};
    if (contact_.maximum_force && pressing > Real(rational(*contact_.maximum_force)))
      return StepFailure::surface_gave_way;

    const bool sticks = contact_.grip == Grip::stick;
    const double friction = sticks ? contact_.static_friction : contact_.dynamic_friction;
    const ClippedForce held = clipped(force, surface, rational(friction), rational(ask_.brake));
    return held.grip == Grip::stick ? stay(held.force_in_wheel) : slide(held.force_in_wheel);
  }

 private:
  // Of the springs and dampers on the pebble.
  Triple<Rational> spring_force() const {
    const Wheel& wheel = ask_.wheel;
    const Rational k_xy = rational(wheel.k_xy), d_xy = rational(wheel.d_xy);
    const Rational k_z = rational(wheel.k_z), d_z = rational(wheel.d_z);
    const auto& [x, y, z] = pebble_in_wheel_;
    const auto& [w_x, w_y, w_z] = velocity_in_wheel_;
    return {k_xy * x + d_xy * w_x, k_xy * y + d_xy * w_y, k_z * (z - rational(wheel.z_zero)) + d_z * w_z};
  }

  Vector on_frame(const Triple<Real>& force_on_pebble_in_wheel) const {
    return rounded(-frame_.world_from_wheel_direction(force_on_pebble_in_wheel), "force");
  }

  StepAnswer stay(const Triple<Real>& force_in_wheel) const {
    Contact next = contact_;
    next.grip = Grip::stick;
    next.pebble_velocity_in_world = {};
    return Stepped{next, on_frame(force_in_wheel)};
  }

  StepAnswer slide(const Triple<Real>& force_in_wheel) const {
    const Landing found =
        landing(scene_, frame_, ask_.wheel, relocated(force_in_wheel, 0), relocated(force_in_wheel, 1));
    if (const auto* failure = std::get_if<StepFailure>(&found)) return *failure;
    if (const auto* ground = std::get_if<Ground>(&found)) {
      const Rational per_second = 1 / rational(ask_.h);
      const Triple<Real> velocity = per_second * (ground->point_in_world - real(pebble_in_world_));
      return Stepped{contact_on(*ground, Grip::slip, velocity), on_frame(force_in_wheel)};
    }
    return Stepped{Free{}, on_frame(force_in_wheel)};
  }

  // The new x (axis 0) or y (axis 1) of the pebble in the wheel.
  Real relocated(const Triple<Real>& force_in_wheel, std::size_t axis) const {
    const Rational k = rational(ask_.wheel.k_xy);
    if (ask_.wheel.relocation == Relocation::spring) return force_in_wheel[axis] * Rational(1 / k);
    const Rational d = rational(ask_.wheel.d_xy);
    const Rational d_per_step = d / rational(ask_.h);
    const Rational known = d_per_step * pebble_in_wheel_[axis] - d * velocity_in_wheel_[axis];
    return (force_in_wheel[axis] + Real(known)) * Rational(1 / (k + d_per_step));
  }

  const PreparedScene& scene_;
  const StepAsk& ask_;
  const Contact& contact_;
  WheelFrame frame_;
  Triple<Rational> pebble_in_world_;
  Triple<Rational> pebble_in_wheel_;
  Triple<Rational> velocity_in_wheel_;  // of the pebble against the frame
};

}  // namespace

StepAnswer step(const Scene& scene, const StepAsk& ask) {
  try {
    if (const auto* contact = std::get_if<Contact>(&ask.state))
      return ContactStep(scene.prepared(), ask, *contact).answer();
    return step_from_free(scene.prepared(), ask);
  } catch (const Refused& refused) {
    return Refusal{refused.what()};
  }
}

}  // namespace groundtruth::definition
