// Mistakes of the step in frames, springs and damping.

#include <cmath>

#include "plain_step.hpp"

namespace groundtruth::planted {
namespace {

struct NoTurning : PlainStep {
  using PlainStep::PlainStep;
  Seen seen(const Contact& contact) const override {
    Seen in_wheel = PlainStep::seen(contact);
    in_wheel.velocity = world_from_wheel.inverse(numbers(contact.pebble_velocity_in_world) -
                                                 numbers(ask.frame.velocity_in_world));
    return in_wheel;
  }
};

// Answers as if the pebble, as it is in the world, moved with this velocity.
struct OtherVelocity : PlainStep {
  using PlainStep::PlainStep;
  Seen seen(const Contact& contact) const final {
    Seen in_wheel = PlainStep::seen(contact);
    in_wheel.velocity = velocity(contact);
    return in_wheel;
  }
  virtual Numbers velocity(const Contact& contact) const = 0;
  Numbers omega() const { return numbers(ask.frame.angular_velocity_in_world); }
  Numbers rolling(const Contact& contact) const {
    return numbers(contact.pebble_velocity_in_world) - numbers(ask.frame.velocity_in_world);
  }
};

struct TurnsOtherWay : OtherVelocity {
  using OtherVelocity::OtherVelocity;
  Numbers velocity(const Contact& contact) const override {
    return world_from_wheel.inverse(rolling(contact) + cross(omega(), arm(contact)));
  }
};

struct ArmFromOrigin : OtherVelocity {
  using OtherVelocity::OtherVelocity;
  Numbers velocity(const Contact& contact) const override {
    return world_from_wheel.inverse(rolling(contact) - cross(omega(), numbers(contact.pebble_in_world)));
  }
};

struct OmegaInWheel : OtherVelocity {
  using OtherVelocity::OtherVelocity;
  Numbers velocity(const Contact& contact) const override {
    return world_from_wheel.inverse(rolling(contact) - cross(world_from_wheel(omega()), arm(contact)));
  }
};

struct VelocityInWheel : OtherVelocity {
  using OtherVelocity::OtherVelocity;
  Numbers velocity(const Contact& contact) const override {
    return rolling(contact) - cross(omega(), arm(contact));
  }
};

struct VelocityTurnedForwards : OtherVelocity {
  using OtherVelocity::OtherVelocity;
  Numbers velocity(const Contact& contact) const override {
    return world_from_wheel(rolling(contact) - cross(omega(), arm(contact)));
  }
};

struct PebbleAtRest : OtherVelocity {
  using OtherVelocity::OtherVelocity;
  Numbers velocity(const Contact& contact) const override {
    Contact at_rest = contact;
    at_rest.pebble_velocity_in_world = {};
    return PlainStep::seen(at_rest).velocity;
  }
};

struct NormalInWorld : PlainStep {
  using PlainStep::PlainStep;
  Seen seen(const Contact& contact) const override {
    Seen in_wheel = PlainStep::seen(contact);
    in_wheel.normal = numbers(contact.normal_in_world);
    return in_wheel;
  }
};

// q v q* is longer than v if q is longer than 1.
struct LongQuaternion : PlainStep {
  using PlainStep::PlainStep;
  Seen seen(const Contact& contact) const override {
    const Quaternion& q = ask.frame.world_from_wheel;
    Number squared = 0;
    for (const double component : q) squared += Number(component) * component;
    Seen in_wheel = PlainStep::seen(contact);
    in_wheel.pebble = squared * in_wheel.pebble;
    in_wheel.velocity = squared * in_wheel.velocity;
    return in_wheel;
  }
};

struct ArmInFloat : PlainStep {
  using PlainStep::PlainStep;
  Seen seen(const Contact& contact) const override {
    Seen in_wheel = PlainStep::seen(contact);
    Vector near = doubles(arm(contact));
    for (double& component : near) {
      if (std::abs(component) < 1e38) component = static_cast<float>(component);
    }
    in_wheel.pebble = world_from_wheel.inverse(numbers(near));
    return in_wheel;
  }
};

// The springs' force, from a wheel that is not the one asked about.
template <void (*mistake)(Wheel& wheel, const Seen& seen)>
struct OtherSprings : PlainStep {
  using PlainStep::PlainStep;
  Numbers spring_force(const Seen& in_wheel) const override {
    StepAsk other = ask;
    mistake(other.wheel, in_wheel);
    const auto& [p, w, n] = in_wheel;
    return {other.wheel.k_xy * p[0] + other.wheel.d_xy * w[0],
            other.wheel.k_xy * p[1] + other.wheel.d_xy * w[1],
            other.wheel.k_z * (p[2] - other.wheel.z_zero) + other.wheel.d_z * w[2]};
  }
};

void same_damping(Wheel& wheel, const Seen&) { wheel.d_z = wheel.d_xy; }
void damping_swapped(Wheel& wheel, const Seen&) { std::swap(wheel.d_z, wheel.d_xy); }
void same_stiffness(Wheel& wheel, const Seen&) { wheel.k_z = wheel.k_xy; }
void zero_at_maximum(Wheel& wheel, const Seen&) { wheel.z_zero = wheel.z_max; }
void no_rebound_damping(Wheel& wheel, const Seen& in_wheel) {
  if (in_wheel.velocity[2] > 0) wheel.d_z = 0;
}
void no_pull_beyond_zero(Wheel& wheel, const Seen& in_wheel) {
  if (in_wheel.pebble[2] > wheel.z_zero) wheel.k_z = 0;
}

struct NoSidewaysDamping : PlainStep {
  using PlainStep::PlainStep;
  Numbers spring_force(const Seen& in_wheel) const override {
    Numbers force = PlainStep::spring_force(in_wheel);
    force[1] = wheel.k_xy * in_wheel.pebble[1];
    return force;
  }
};

struct ForceOnPebble : PlainStep {
  using PlainStep::PlainStep;
  Vector force_on_frame(const Numbers& clipped) const override { return doubles(world_from_wheel(clipped)); }
};

struct ForceInWheel : PlainStep {
  using PlainStep::PlainStep;
  Vector force_on_frame(const Numbers& clipped) const override { return doubles(Number(-1) * clipped); }
};

}  // namespace

std::vector<Bug> motion_bugs() {
  using enum Reach;
  constexpr Kind step = Kind::step;
  return {
      {"omega-ignored", step, special, "the frame's angular velocity is ignored", steps<NoTurning>()},
      {"omega-other-way", step, special, "omega x arm has the other sign", steps<TurnsOtherWay>()},
      {"omega-arm-from-origin", step, special, "omega acts on p_t instead of p_t - b",
       steps<ArmFromOrigin>()},
      {"omega-in-wheel", step, special, "omega is taken as in wheel coordinates", steps<OmegaInWheel>()},
      {"velocity-not-turned", step, special, "velocities are not turned into the wheel",
       steps<VelocityInWheel>()},
      {"velocity-turned-forwards", step, special, "velocities are turned by q instead of its inverse",
       steps<VelocityTurnedForwards>()},
      {"pebble-at-rest", step, special, "a slipping pebble's velocity is ignored", steps<PebbleAtRest>()},
      {"normal-not-turned", step, special, "the normal is not turned into the wheel", steps<NormalInWorld>()},
      {"long-quaternion", step, special, "the quaternion's length scales the pebble",
       steps<LongQuaternion>()},
      {"arm-in-float", step, special, "the pebble's offset is kept in float", steps<ArmInFloat>()},
      {"same-damping", step, common, "d_xy damps z", steps<OtherSprings<same_damping>>()},
      {"damping-swapped", step, common, "d_xy and d_z are swapped", steps<OtherSprings<damping_swapped>>()},
      {"same-stiffness", step, common, "k_xy is used for z", steps<OtherSprings<same_stiffness>>()},
      {"zero-at-maximum", step, special, "z_max is used for z_zero", steps<OtherSprings<zero_at_maximum>>()},
      {"no-rebound-damping", step, special, "z is damped only while it shortens",
       steps<OtherSprings<no_rebound_damping>>()},
      {"no-pull-beyond-zero", step, special, "beyond z_zero the spring gives no force",
       steps<OtherSprings<no_pull_beyond_zero>>()},
      {"no-sideways-damping", step, special, "y is not damped", steps<NoSidewaysDamping>()},
      {"force-on-pebble", step, common, "the force is that on the pebble", steps<ForceOnPebble>()},
      {"force-in-wheel", step, special, "the force is in wheel coordinates", steps<ForceInWheel>()},
  };
}

}  // namespace groundtruth::planted
