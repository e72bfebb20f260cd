// Mistakes of the step about what comes next.

#include "plain_step.hpp"

namespace groundtruth::planted {
namespace {

struct FrictionSwapped : PlainStep {
  using PlainStep::PlainStep;
  Number friction(const Contact& contact) const override {
    return contact.grip == Grip::stick ? contact.dynamic_friction : contact.static_friction;
  }
};

struct StaticAlways : PlainStep {
  using PlainStep::PlainStep;
  Number friction(const Contact& contact) const override { return contact.static_friction; }
};

struct StaticWhileSlow : PlainStep {
  using PlainStep::PlainStep;
  Number friction(const Contact& contact) const override {
    const Numbers velocity = seen(contact).velocity;
    return length(velocity) < 0.01 ? Number(contact.static_friction) : PlainStep::friction(contact);
  }
};

struct NoBrakeAtRest : PlainStep {
  using PlainStep::PlainStep;
  Number brake(const Contact& contact) const override {
    return contact.grip == Grip::stick ? Number(1e300) : PlainStep::brake(contact);
  }
};

struct BrakeImpulse : PlainStep {
  using PlainStep::PlainStep;
  Number brake(const Contact&) const override { return Number(ask.brake) * ask.h; }
};

struct StillTouchingAtMaximum : PlainStep {
  using PlainStep::PlainStep;
  std::optional<StepAnswer> at_limits(const Seen& in_wheel, const Contact& contact) const override {
    if (compare(in_wheel.pebble[2], wheel.z_max) == 0) return std::nullopt;
    return PlainStep::at_limits(in_wheel, contact);
  }
};

struct WholeAtMinimum : PlainStep {
  using PlainStep::PlainStep;
  std::optional<StepAnswer> at_limits(const Seen& in_wheel, const Contact& contact) const override {
    if (compare(in_wheel.pebble[2], wheel.z_min) == 0) return std::nullopt;
    return PlainStep::at_limits(in_wheel, contact);
  }
};

struct StaysBehind : PlainStep {
  using PlainStep::PlainStep;
  std::optional<StepAnswer> at_limits(const Seen& in_wheel, const Contact& contact) const override {
    if (compare(in_wheel.pebble[2], wheel.z_max) >= 0) return stay(contact, {});
    return PlainStep::at_limits(in_wheel, contact);
  }
};

struct FreeAtZero : PlainStep {
  using PlainStep::PlainStep;
  std::optional<StepAnswer> at_limits(const Seen& in_wheel, const Contact& contact) const override {
    if (compare(in_wheel.pebble[2], wheel.z_zero) >= 0) return no_contact();
    return PlainStep::at_limits(in_wheel, contact);
  }
};

struct Pulls : PlainStep {
  using PlainStep::PlainStep;
  std::optional<StepAnswer> under_pressure(const Number& pressure, const Numbers& force,
                                           const Contact& contact) const override {
    if (pressure <= 0) return std::nullopt;
    return PlainStep::under_pressure(pressure, force, contact);
  }
};

struct BarelyTouches : PlainStep {
  using PlainStep::PlainStep;
  std::optional<StepAnswer> under_pressure(const Number& pressure, const Numbers& force,
                                           const Contact& contact) const override {
    if (compare(pressure, 0, length(force)) == 0) return std::nullopt;
    return PlainStep::under_pressure(pressure, force, contact);
  }
};

struct GivesWayAtLimit : PlainStep {
  using PlainStep::PlainStep;
  std::optional<StepAnswer> under_pressure(const Number& pressure, const Numbers& force,
                                           const Contact& contact) const override {
    const auto& limit = contact.maximum_force;
    const bool reached = limit && compare(pressure, 0, length(force)) > 0 && compare(pressure, *limit) == 0;
    if (reached) return StepFailure::surface_gave_way;
    return PlainStep::under_pressure(pressure, force, contact);
  }
};

struct WholeForceGivesWay : PlainStep {
  using PlainStep::PlainStep;
  std::optional<StepAnswer> under_pressure(const Number& pressure, const Numbers& force,
                                           const Contact& contact) const override {
    const Number size = pressure > 0 ? length(force) : pressure;
    return PlainStep::under_pressure(size, force, contact);
  }
};

template <std::optional<double> (*misread)(std::optional<double> limit)>
struct OtherLimit : PlainStep {
  using PlainStep::PlainStep;
  std::optional<StepAnswer> under_pressure(const Number& pressure, const Numbers& force,
                                           const Contact& contact) const override {
    Contact other = contact;
    other.maximum_force = misread(contact.maximum_force);
    return PlainStep::under_pressure(pressure, force, other);
  }
};

std::optional<double> none_is_zero(std::optional<double> limit) { return limit.value_or(0); }
std::optional<double> zero_is_none(std::optional<double> limit) {
  return limit == 0.0 ? std::nullopt : limit;
}

struct ForceBeforeSteepness : PlainStep {
  using PlainStep::PlainStep;
  bool is_upright(const Numbers&) const override { return true; }
  std::optional<StepAnswer> under_pressure(const Number& pressure, const Numbers& force,
                                           const Contact& contact) const override {
    if (const auto end = PlainStep::under_pressure(pressure, force, contact)) return end;
    if (!PlainStep::is_upright(seen(contact).normal)) return StepFailure::surface_too_steep;
    return std::nullopt;
  }
};

struct SlipsOn : PlainStep {
  using PlainStep::PlainStep;
  StepAnswer stay(const Contact& contact, const Vector& force) const override {
    Contact kept = contact;
    kept.pebble_velocity_in_world = {};
    return Stepped{kept, force};
  }
};

struct SlipsWhileFast : SlipsOn {
  using SlipsOn::SlipsOn;
  StepAnswer stay(const Contact& contact, const Vector& force) const override {
    const bool is_fast = length(numbers(contact.pebble_velocity_in_world)) > 1;
    return is_fast ? SlipsOn::stay(contact, force) : PlainStep::stay(contact, force);
  }
};

struct StuckMoves : PlainStep {
  using PlainStep::PlainStep;
  StepAnswer stay(const Contact& contact, const Vector& force) const override {
    Contact stuck = contact;
    stuck.grip = Grip::stick;
    return Stepped{stuck, force};
  }
};

}  // namespace

std::vector<Bug> state_bugs() {
  using enum Reach;
  constexpr Kind step = Kind::step;
  return {
      {"friction-swapped", step, special, "static and dynamic friction are swapped",
       steps<FrictionSwapped>()},
      {"static-always", step, special, "a slip is clipped with static friction", steps<StaticAlways>()},
      {"static-while-slow", step, special, "a slip below 1 cm/s is clipped with static friction",
       steps<StaticWhileSlow>()},
      {"no-brake-at-rest", step, special, "a stuck wheel is clipped without the brake",
       steps<NoBrakeAtRest>()},
      {"brake-impulse", step, special, "the brake is multiplied by h", steps<BrakeImpulse>()},
      {"touches-at-maximum", step, tied, "p_z = z_max is still in contact", steps<StillTouchingAtMaximum>()},
      {"whole-at-minimum", step, tied, "p_z = z_min is not broken yet", steps<WholeAtMinimum>()},
      {"stays-behind", step, special, "beyond z_max the pebble stays stuck, without force",
       steps<StaysBehind>()},
      {"free-at-zero", step, special, "the wheel is free from z_zero on", steps<FreeAtZero>()},
      {"pulls", step, special, "the ground may pull", steps<Pulls>()},
      {"barely-touches", step, tied, "F'_z = 0 is still in contact", steps<BarelyTouches>()},
      {"gives-way-at-limit", step, tied, "F'_z = F_m gives way", steps<GivesWayAtLimit>()},
      {"whole-force-gives-way", step, special, "F_m is compared with |F|", steps<WholeForceGivesWay>()},
      {"no-limit-is-zero", step, special, "no maximum force is read as 0", steps<OtherLimit<none_is_zero>>()},
      {"limit-zero-is-none", step, special, "maximum force 0 is read as none",
       steps<OtherLimit<zero_is_none>>()},
      {"force-before-steepness", step, special, "steepness is looked at after the force",
       steps<ForceBeforeSteepness>()},
      {"slips-on", step, special, "a slip whose force is borne stays a slip", steps<SlipsOn>()},
      {"slips-while-fast", step, special, "... if it is faster than 1 m/s", steps<SlipsWhileFast>()},
      {"stuck-moves", step, special, "a pebble that sticks keeps its velocity", steps<StuckMoves>()},
  };
}

}  // namespace groundtruth::planted
