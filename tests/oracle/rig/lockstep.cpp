#include <groundtruth/tests/oracle/rig/lockstep.hpp>

#include <algorithm>

#include <groundtruth/judge/difference.hpp>
#include <groundtruth/rig/motion.hpp>
#include <groundtruth/text/ask_text.hpp>
#include <groundtruth/text/scene_text.hpp>

namespace groundtruth::rig {
namespace {

// Answers what `exact` says, and holds `fast` against it.
class Pair : public implementations::EngineOnScene {
 public:
  Pair(const Scene& scene, Lockstep& lockstep)
      : scene_(scene),
        exact_(implementations::make_engine("exact")->on(scene)),
        fast_(implementations::make_engine("fast")->on(scene)),
        lockstep_(lockstep) {}

  implementations::Answered answer(const Ask& ask) const override {
    implementations::Answered expected = exact_->answer(ask);
    const implementations::Answered got = fast_->answer(ask);
    compare(std::get<StepAnswer>(got.answer), std::get<StepAnswer>(expected.answer), ask);
    return expected;
  }

 private:
  void compare(const StepAnswer& got, const StepAnswer& expected, const Ask& ask) const {
    ++lockstep_.wheel_steps;
    if (const auto* stepped = std::get_if<Stepped>(&expected)) {
      const auto* contact = std::get_if<Contact>(&stepped->state);
      if (contact != nullptr && contact->grip == Grip::slip) ++lockstep_.slip_steps;
    }
    if (got == expected) return;
    ++lockstep_.differences;
    const Evidence none;
    const Answer left = got, right = expected;
    lockstep_.worst_force_ulps =
        std::max(lockstep_.worst_force_ulps, judge::compare({left, none}, {right, none}).vector_ulps);
    if (lockstep_.first_difference.empty())
      lockstep_.first_difference = write_scene_line(scene_) + "\n" + write_ask("\"differs\"", ask);
  }

  const Scene& scene_;
  std::unique_ptr<const implementations::EngineOnScene> exact_, fast_;
  Lockstep& lockstep_;
};

}  // namespace

void Lockstep::add(const Lockstep& other) {
  wheel_steps += other.wheel_steps;
  slip_steps += other.slip_steps;
  differences += other.differences;
  worst_force_ulps = std::max(worst_force_ulps, other.worst_force_ulps);
  if (first_difference.empty()) first_difference = other.first_difference;
}

Lockstep lockstep_of(const Scenario& scenario, int steps) {
  Lockstep lockstep;
  const Pair pair(scenario.scene, lockstep);
  Motion motion(scenario.machine, pair, scenario.integrator, scenario.h);
  MotionState state{scenario.start, std::vector<WheelState>(scenario.machine.wheels.size(), Free{}), 0};
  for (int i = 0; i < steps; ++i)
    if (motion.advance(state, scenario.inputs.at(i * scenario.h)).halt != Halt::none) break;
  return lockstep;
}

}  // namespace groundtruth::rig
