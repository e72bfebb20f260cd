#include <groundtruth/tests/oracle/rig/landings.hpp>

#include <cmath>

namespace groundtruth::rig {
namespace {

double between(properties::Dice& dice, double low, double high) {
  return low + (high - low) * (static_cast<double>(dice.bits() >> 11) * 0x1p-53);
}

}  // namespace

Scenario random_landing(const LandingKind& kind, double stiffest, properties::Dice& dice) {
  stability::Parked parked;
  parked.wheels = kind.wheels;
  parked.h_omega = 0.02 * std::pow(stiffest / 0.02, between(dice, 0, 1));
  parked.damping_ratio = dice.one_in(5) ? 0 : between(dice, 0, 1);
  parked.slope = 0;
  parked.integrator = kind.integrator;
  parked.relocation = kind.relocation;
  Scenario scenario = stability::scenario_of(parked, 150);
  scenario.start.position_in_world.z() = 1.15;
  scenario.start.velocity_in_world = {between(dice, 0, 60), between(dice, -3, 3), -between(dice, 1, 6)};
  scenario.inputs.brake.points = {{0, dice.one_in(4) ? 0 : between(dice, 0, 12000)}};
  return scenario;
}

}  // namespace groundtruth::rig
