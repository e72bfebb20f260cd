// What one might take for a law, with the numbers that refute it (proofs-notes/rig.md, 5). Each test fails if
// its counterexample stops being one.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_int.hpp>

#include <groundtruth/rig/simulation.hpp>
#include <groundtruth/stability/parked.hpp>
#include <groundtruth/tests/oracle/rig/landings.hpp>
#include <groundtruth/tests/oracle/rig/random_scenarios.hpp>

namespace groundtruth::rig {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using stability::Parked;
using stability::Wheels;

// On level ground, pressed with 1 N, without a band.
Vector clipped(const Vector& force, double friction) {
  const auto engine = implementations::make_engine("exact")->on({{}, {Everything{}}});
  const ClipAsk ask{force, {0, 0, -1}, friction, 10};
  return std::get<Clipped>(std::get<ClipAnswer>(engine->answer(ask).answer)).force_in_wheel;
}

TEST(KnownFalse, TheClippedForceRoundedToDoublesLiesInTheDisc) {
  const double friction = 0x1.031ead07106b4p-1;
  const Vector h = clipped({-0x1.192ec7e0cdc6cp+1, -0x1.173d490f96b52p+1, -1}, friction);
  const Rational x = h[0], y = h[1], r = friction;
  EXPECT_GT(x * x + y * y, r * r);
  EXPECT_NEAR(static_cast<double>(x * x + y * y - r * r), 7.86476e-18, 1e-22);
}

TEST(KnownFalse, ClippingTheClippedDoublesChangesNothing) {
  const double friction = 0x1.27652614dcce4p-1;
  const Vector once = clipped({0x1.bdc175427f934p+0, -0x1.4a2a9eb595af8p-1, -1}, friction);
  const Vector twice = clipped(once, friction);
  EXPECT_EQ(once[1], -0x1.9a5ad452a00ecp-3);
  EXPECT_EQ(twice[1], -0x1.9a5ad452a00ebp-3);
}

// The pebble of a strut that the step has shortened by a third: 0.1 m of coordinates near 1 m and near 2^20 m
// are not the same doubles.
TEST(KnownFalse, AShiftedWorldGivesTheSameRunInDoubles) {
  const Scenario here = stability::scenario_of(Parked{}, 1);
  Scenario there = here;
  const double away = 0x1p20;
  there.start.position_in_world.y() += away;
  there.start.position_in_world.x() += 0.1;
  Scenario near = here;
  near.start.position_in_world.x() += 0.1;
  EXPECT_TRUE(is_same(run_of(near, "fast", 1)[0], run_of(near, "fast", 1)[0]));
  const double lifted_here = run_of(near, "fast", 400).back().body.position_in_world.z();
  near.start.position_in_world.z() += away;
  near.scene.shape = {Covered{0, std::make_shared<Shape>(Shape{HalfSpace{{-0.05, 0, 1}, away}})}};
  const double lifted_there = run_of(near, "fast", 400).back().body.position_in_world.z();
  EXPECT_NE(lifted_there - away, lifted_here);
  EXPECT_NEAR(lifted_there - away, lifted_here, 1e-8);
}

// Let go with slack springs, the body swings to twice the stretch at which it will hang: at 0.3 it slips,
// though both coefficients are greater; at 0.2 it does not.
TEST(KnownFalse, AReleasedBodySticksIfTheSlopeIsBelowTheStaticCoefficient) {
  Parked parked;
  parked.damping_ratio = 0;
  parked.slope = 0.2;
  EXPECT_EQ(play(stability::scenario_of(parked, 2000), "fast").wheel_steps_slip, 0U);
  parked.slope = 0.3;
  EXPECT_GT(play(stability::scenario_of(parked, 2000), "fast").wheel_steps_slip, 0U);
}

// Touching down at 20 m/s with the brakes on.
Scenario slide(Relocation relocation, double damping_ratio, Integrator integrator) {
  const Parked parked{Wheels::one, 1.0 / 3, damping_ratio, 0, integrator, relocation};
  Scenario scenario = stability::scenario_of(parked, 200);
  scenario.start.velocity_in_world.x() = 20;
  return scenario;
}

// Implicit steps on one wheel that stands upright.
TEST(KnownFalse, TheSpringRelocationMakesNoEnergy) {
  const auto rise = [](Relocation relocation) {
    properties::Dice dice(1);
    double most = 0;
    for (int i = 0; i < 60; ++i)
      most = std::max(
          most, play(random_landing({Wheels::one, Integrator::implicit, relocation}, 0.33, dice), "fast")
                    .energy_rise);
    return most;
  };
  EXPECT_GT(rise(Relocation::spring), 0.05);
  EXPECT_LT(rise(Relocation::return_mapping), 1e-12);
}

// A strut that leans by 1 % against the ground, at 20 m/s uphill. The pebble lies v h behind when the step
// begins, and a slip moves it under the wheel again: the strut's line meets the ground elsewhere, and the
// strut is found compressed by v h / 100 more than the force has done.
TEST(KnownFalse, TheReturnMappingMakesNoEnergyWhereAStrutLeansAgainstTheGround) {
  const auto rise = [](double slope) {
    const Parked parked{Wheels::one, 0.3, 0.3, slope, Integrator::implicit, Relocation::return_mapping};
    Scenario scenario = stability::scenario_of(parked, 100);
    scenario.start.world_from_body = Eigen::Quaterniond(0, 1, 0, 0);
    scenario.start.velocity_in_world = {20, 0, 20 * slope};
    return play(scenario, "fast").energy_rise;
  };
  EXPECT_NEAR(rise(0.01), 0.0025, 0.0005);
  EXPECT_LT(rise(0), 1e-12);
}

// The largest energy of the spring along x, in parts of the kinetic energy, while faster than 5 m/s.
double stored(const Scenario& scenario) {
  double most = 0;
  play(scenario, "fast", Repetitions::played, [&](const Moment& moment) {
    const auto* contact = std::get_if<Contact>(&moment.state.wheels[0]);
    const BodyState& body = moment.state.body;
    if (contact == nullptr || body.velocity_in_world.x() < 5) return;
    const double stretch = contact->pebble_in_world[0] - body.position_in_world.x();
    const double spring = -scenario.machine.wheels[0].wheel.k_xy * stretch * stretch / 2;
    most = std::max(most, spring / (scenario.machine.mass * body.velocity_in_world.squaredNorm() / 2));
  });
  return most;
}

// The contract's w_t is the pebble's own velocity, v in a steady slide: the spring then stores d v.
TEST(KnownFalse, TheReturnMappingKeepsTheSpringsOfASlideShortWhateverTheDamping) {
  EXPECT_NEAR(stored(slide(Relocation::return_mapping, 1, Integrator::semi_implicit)), 6.887, 0.001);
  EXPECT_NEAR(stored(slide(Relocation::return_mapping, 0.1, Integrator::semi_implicit)), 0.322, 0.001);
  EXPECT_NEAR(stored(slide(Relocation::spring, 1, Integrator::semi_implicit)), 0.131, 0.001);
  EXPECT_LT(stored(slide(Relocation::return_mapping, 1, Integrator::implicit)), 8e-4);
}

}  // namespace
}  // namespace groundtruth::rig
