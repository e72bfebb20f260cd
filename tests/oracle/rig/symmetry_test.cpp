// Whole runs seen in a mirror and in other units: the same to the last bit.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <groundtruth/stability/parked.hpp>
#include <groundtruth/tests/oracle/rig/random_scenarios.hpp>

namespace groundtruth::rig {
namespace {

Scenario some_scenario() {
  properties::Dice dice(*rc::gen::arbitrary<std::uint64_t>());
  return random_scenario(dice);
}

template <typename Map>
void is_the_same_run(const std::vector<MotionState>& seen, const std::vector<MotionState>& original,
                     const Map& map) {
  RC_ASSERT(seen.size() == original.size());
  for (std::size_t i = 0; i < seen.size(); ++i) RC_ASSERT(is_same(seen[i], map(original[i])));
}

RC_GTEST_PROP(Symmetry, InAMirrorTheRunIsMirrored, ()) {
  const Scenario scenario = some_scenario();
  is_the_same_run(run_of(mirrored(scenario), "fast", 150), run_of(scenario, "fast", 150),
                  [](const MotionState& state) { return mirrored(state); });
}

RC_GTEST_PROP(Symmetry, InOtherUnitsTheRunIsTheSame, ()) {
  const Scenario scenario = some_scenario();
  // The implicit solver compares velocities with angular velocities: metres must stay metres there.
  const bool may_change_metres = scenario.integrator != Integrator::implicit;
  const Units units{may_change_metres ? *rc::gen::element(0.5, 1.0, 4.0, 0x1p20) : 1.0,
                    *rc::gen::element(0.5, 1.0, 2.0), *rc::gen::element(0.25, 1.0, 0x1p10)};
  if (!may_change_metres) RC_PRE(units.time == 1);
  is_the_same_run(run_of(in_units(scenario, units), "fast", 150), run_of(scenario, "fast", 150),
                  [&](const MotionState& state) { return in_units(state, units); });
}

// Left and right wheel stand and bear alike, so what would turn or shift the body cancels exactly.
RC_GTEST_PROP(Symmetry, SymmetricBrakingKeepsYRollAndYawAtZero, ()) {
  stability::Parked parked;
  parked.wheels = stability::Wheels::three;
  parked.h_omega = *rc::gen::element(0.1, 0.4, 1.0);
  parked.damping_ratio = *rc::gen::element(0.1, 0.5);
  parked.integrator =
      *rc::gen::element(Integrator::semi_implicit, Integrator::half_kick, Integrator::implicit);
  parked.relocation = *rc::gen::element(Relocation::spring, Relocation::return_mapping);
  Scenario scenario = stability::scenario_of(parked, 1);
  scenario.start.angular_velocity_in_world.setZero();
  scenario.start.velocity_in_world.x() = *rc::gen::inRange(0, 300) / 10.0;
  scenario.inputs.brake.points = {{0, *rc::gen::inRange(0, 8000) * 1.0}};
  for (const MotionState& state : run_of(scenario, "fast", 300)) {
    const BodyState& body = state.body;
    RC_ASSERT(body.position_in_world.y() == 0);
    RC_ASSERT(body.velocity_in_world.y() == 0);
    RC_ASSERT(body.angular_velocity_in_world.x() == 0);
    RC_ASSERT(body.angular_velocity_in_world.z() == 0);
    RC_ASSERT(body.world_from_body.w() == 0);
    RC_ASSERT(body.world_from_body.y() == 0);
  }
}

}  // namespace
}  // namespace groundtruth::rig
