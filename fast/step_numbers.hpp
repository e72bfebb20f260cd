#pragma once
// The numbers of a step whose decisions are known. Not installed.

#include <groundtruth/fast/step_plan.hpp>

namespace groundtruth::fast {

// Correctly rounded; nothing where one is uncertain.
template <class Real>
class StepNumbers {
 public:
  StepNumbers(const StepAsk& ask, const StepPlan& plan) : ask_(ask), plan_(plan) {}

  std::optional<StepAnswer> answer() const {
    if (const auto* failure = std::get_if<StepFailure>(&plan_.touch)) return *failure;
    if (const auto* refusal = std::get_if<Refusal>(&plan_.touch)) return *refusal;
    if (plan_.bears_force) return under(std::get<Contact>(ask_.state));
    if (std::holds_alternative<NoContact>(plan_.touch)) return Stepped{Free{}, {}};
    return first_contact(std::get<Contacted>(plan_.touch));
  }

 private:
  std::optional<StepAnswer> first_contact(const Contacted& contacted) const {
    const WheelAxes<Real> axes(ask_.frame.world_from_wheel);
    const CountedVector<Real, 0> at_frame{};
    const auto landing = CountedStrut(ask_, axes, at_frame).landing_on(contacted.plane);
    const auto pebble = nearest_doubles(landing.pebble_in_world);
    if (!pebble) return std::nullopt;
    return Stepped{contacted.surface.contact(Grip::stick, *pebble, {}), {}};
  }

  std::optional<StepAnswer> under(const Contact& contact) const {
    const Load<Real> load(ask_, contact);
    const auto velocity = load.velocity();
    const auto force = load.force(velocity);
    if (plan_.clipping != Clipping::none) {
      const auto grasp = load.grasp();
      const auto forward = load.forward();
      return ForceOnSurface(grasp, forward, force).clipped(plan_.clipping, [&](const auto& clipped) {
        return slip(load, velocity, clipped);
      });
    }
    Contact stuck = contact;
    stuck.grip = Grip::stick;
    stuck.pebble_velocity_in_world = {};
    return answer_with(stuck, force);
  }

  template <int m, int n>
  std::optional<StepAnswer> slip(const Load<Real>& load, const CountedVector<Real, m>& old_velocity,
                                 const CountedVector<Real, n>& clipped) const {
    if (std::holds_alternative<NoContact>(plan_.touch)) return answer_with(Free{}, clipped);
    const auto& contacted = std::get<Contacted>(plan_.touch);
    const auto offset = load.relocated(clipped, old_velocity);
    const auto landing = CountedStrut(ask_, load.axes(), offset).landing_on(contacted.plane);
    const auto pebble = nearest_doubles(landing.pebble_in_world);
    if (!pebble) return std::nullopt;
    const auto velocity = nearest_doubles(velocity_of(load, landing));
    if (!velocity) return std::nullopt;
    return answer_with(contacted.surface.contact(Grip::slip, *pebble, *velocity), clipped);
  }

  // From the old place to the new one in a step.
  template <int n>
  CountedVector<Real, n + 4> velocity_of(const Load<Real>& load, const Landing<Real, n>& landing) const {
    const auto inverse = counted<Real>(1) / counted<Real>(ask_.h);
    CountedVector<Real, n + 4> velocity;
    for (std::size_t axis = 0; axis < 3; ++axis)
      velocity[axis] = (landing.from_frame_in_world[axis] - load.arm()[axis]) * inverse;
    if (const auto& level = landing.level)
      velocity[level->axis] =
          difference<Real>(level->value, load.contact().pebble_in_world[level->axis]) * inverse;
    return velocity;
  }

  // With the opposite force on the frame.
  template <int n>
  static std::optional<StepAnswer> answer_with(const WheelState& state,
                                               const CountedVector<Real, n>& force_on_pebble) {
    const auto force = nearest_doubles(
        CountedVector<Real, n>{-force_on_pebble[0], -force_on_pebble[1], -force_on_pebble[2]});
    if (!force) return std::nullopt;
    return Stepped{state, *force};
  }

  const StepAsk& ask_;
  const StepPlan& plan_;
};

}  // namespace groundtruth::fast
