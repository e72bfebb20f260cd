#include <groundtruth/tests/oracle/rig/lockstep.hpp>

#include <algorithm>

#include <groundtruth/judge/difference.hpp>
#include <groundtruth/rig/motion.hpp>
#include <groundtruth/text/ask_text.hpp>
#include <groundtruth/text/scene_text.hpp>

namespace groundtruth::rig {
namespace {

// Answers what `exact` says, and holds the other engine against it.
class Pair : public implementations::EngineOnScene {
 public:
  Pair(const Scene& scene, const std::string& engine, Lockstep& lockstep)
      : scene_(scene),
        exact_(implementations::make_engine("exact")->on(scene)),
        other_(implementations::make_engine(engine)->on(scene)),
        lockstep_(lockstep) {}

  implementations::Answered answer(const Ask& ask) const override {
    implementations::Answered expected = exact_->answer(ask);
    const implementations::Answered got = other_->answer(ask);
    if (const auto* step = std::get_if<StepAnswer>(&expected.answer)) count(*step);
    compare(got.answer, expected.answer, ask);
    return expected;
  }

 private:
  void count(const StepAnswer& expected) const {
    ++lockstep_.wheel_steps;
    const auto* stepped = std::get_if<Stepped>(&expected);
    const auto* contact = stepped == nullptr ? nullptr : std::get_if<Contact>(&stepped->state);
    if (contact != nullptr && contact->grip == Grip::slip) ++lockstep_.slip_steps;
  }

  void compare(const Answer& got, const Answer& expected, const Ask& ask) const {
    if (got == expected) return;
    ++lockstep_.differences;
    const Evidence none;
    const judge::Comparison comparison = judge::compare({got, none}, {expected, none});
    lockstep_.worst_ulps = std::max(lockstep_.worst_ulps, comparison.vector_ulps);
    if (lockstep_.first_difference.empty())
      lockstep_.first_difference = write_scene_line(scene_) + "\n" + write_ask("\"differs\"", ask);
  }

  const Scene& scene_;
  std::unique_ptr<const implementations::EngineOnScene> exact_, other_;
  Lockstep& lockstep_;
};

}  // namespace

void Lockstep::add(const Lockstep& other) {
  wheel_steps += other.wheel_steps;
  slip_steps += other.slip_steps;
  differences += other.differences;
  worst_ulps = std::max(worst_ulps, other.worst_ulps);
  if (first_difference.empty()) first_difference = other.first_difference;
}

Lockstep lockstep_of(const Scenario& scenario, int steps, const std::string& engine) {
  Lockstep lockstep;
  const Pair pair(scenario.scene, engine, lockstep);
  Motion motion(scenario.machine, pair, scenario.integrator, scenario.h);
  MotionState state = scenario.state_at_start();
  for (int i = 0; i < steps; ++i)
    if (motion.advance(state, scenario.inputs.at(i * scenario.h)).halt != Halt::none) break;
  return lockstep;
}

std::vector<Scenario> variants_of(const Scenario& scenario) {
  std::vector<Scenario> variants;
  for (const auto integrator : {Integrator::semi_implicit, Integrator::half_kick, Integrator::implicit})
    for (const auto relocation : {Relocation::spring, Relocation::return_mapping}) {
      Scenario variant = scenario;
      variant.integrator = integrator;
      for (MountedWheel& mounted : variant.machine.wheels) mounted.wheel.relocation = relocation;
      variants.push_back(std::move(variant));
    }
  return variants;
}

}  // namespace groundtruth::rig
