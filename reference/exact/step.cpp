#include <groundtruth/exact/step.hpp>

#include <groundtruth/exact/arithmetic/answer_numbers.hpp>
#include <groundtruth/exact/wheel/clipping.hpp>
#include <groundtruth/exact/wheel/landing.hpp>
#include <groundtruth/exact/wheel/motion.hpp>

namespace groundtruth::exact {
namespace {

class Step {
 public:
  Step(const Ground& ground, const StepAsk& ask, Digits digits)
      : ground_(ground), ask_(ask), placement_(ask.frame), numbers_(digits) {}

  Finding<StepAnswer> take() {
    StepAnswer answer = std::visit([this](const auto& state) { return from(state); }, ask_.state);
    if (numbers_.refusal()) return {*numbers_.refusal(), {}};
    return {std::move(answer), std::move(numbers_).evidence()};
  }

 private:
  static StepAnswer no_contact() { return Stepped{Free{}, Vector{}}; }

  static StepAnswer failure_of(const Touch& touch) {
    if (const auto* failure = std::get_if<StepFailure>(&touch)) return *failure;
    return std::get<Refusal>(touch);
  }

  StepAnswer from(const Free&) {
    const RationalVector top_in_wheel(0, 0, Rational(ask_.wheel.z_min));
    const Touch touch = touch_down(ground_, ask_.wheel, placement_, {placement_.to_world(top_in_wheel)});
    if (std::holds_alternative<Clear>(touch)) return no_contact();
    const Landing* landing = std::get_if<Landing>(&touch);
    if (landing == nullptr) return failure_of(touch);
    Contact contact = landing->contact;
    contact.grip = Grip::stick;
    contact.pebble_in_world = numbers_.round("state.pebble", landing->pebble_in_world);
    return Stepped{contact, Vector{}};
  }

  StepAnswer from(const Contact& contact) {
    const ContactInWheel seen = seen_from_wheel(contact, ask_.frame, placement_);
    if (seen.pebble.z() >= Rational(ask_.wheel.z_max)) return no_contact();
    if (seen.pebble.z() <= Rational(ask_.wheel.z_min)) return StepFailure::wheel_broken;
    if (!is_upright(seen.normal, Rational(ask_.wheel.min_uprightness))) return StepFailure::surface_too_steep;
    const RationalVector force_in_wheel = spring_force(ask_.wheel, seen);
    // F'_z = -F.n / ||n||.
    const Rational pressing = -(force_in_wheel * seen.normal);
    if (sign(pressing) <= 0) return no_contact();
    if (contact.maximum_force) {
      const Rational most(*contact.maximum_force);
      if (pressing * pressing > most * most * (seen.normal * seen.normal))
        return StepFailure::surface_gave_way;
    }
    const double friction = contact.grip == Grip::stick ? contact.static_friction : contact.dynamic_friction;
    const ExactClip clipped =
        clip_force(force_in_wheel, seen.normal, {Rational(friction), Rational(ask_.brake)});
    const RootVector on_frame_in_world = transformed(
        clipped.force_in_wheel,
        [this](const RationalVector& force) { return RationalVector(-placement_.world_from_wheel(force)); });
    return clipped.grip == Grip::stick ? stay(contact, on_frame_in_world)
                                       : slide(contact, seen, clipped.force_in_wheel, on_frame_in_world);
  }

  StepAnswer stay(const Contact& contact, const RootVector& on_frame_in_world) {
    Contact stuck = contact;
    stuck.grip = Grip::stick;
    stuck.pebble_velocity_in_world = {};
    return Stepped{stuck, numbers_.round("force", on_frame_in_world.components())};
  }

  StepAnswer slide(const Contact& contact, const ContactInWheel& seen, const RootVector& clipped_in_wheel,
                   const RootVector& on_frame_in_world) {
    const Rational h(ask_.h);
    const auto to_world = [this](const RationalVector& vector) {
      return placement_.world_from_wheel(vector);
    };
    RootVector top_in_world = transformed(relocated(ask_.wheel, seen, clipped_in_wheel, h), to_world);
    top_in_world.u = top_in_world.u + placement_.origin_in_world;
    const Touch touch = touch_down(ground_, ask_.wheel, placement_, top_in_world);
    if (std::holds_alternative<Clear>(touch)) {
      return Stepped{Free{}, numbers_.round("force", on_frame_in_world.components())};
    }
    const Landing* landing = std::get_if<Landing>(&touch);
    if (landing == nullptr) return failure_of(touch);
    std::array<RootSum, 3> velocity_in_world;
    for (std::size_t i = 0; i < 3; ++i) {
      const RootSum before{Rational(contact.pebble_in_world[i])};
      velocity_in_world[i] = (landing->pebble_in_world[i] - before) / h;
    }
    Contact slid = landing->contact;
    slid.grip = Grip::slip;
    slid.pebble_in_world = numbers_.round("state.pebble", landing->pebble_in_world);
    slid.pebble_velocity_in_world = numbers_.round("state.velocity", velocity_in_world);
    return Stepped{slid, numbers_.round("force", on_frame_in_world.components())};
  }

  const Ground& ground_;
  const StepAsk& ask_;
  Placement placement_;
  AnswerNumbers numbers_;
};

}  // namespace

Finding<StepAnswer> step(const Scene& scene, const StepAsk& ask, Digits digits) {
  return Step(scene.ground(), ask, digits).take();
}

}  // namespace groundtruth::exact
