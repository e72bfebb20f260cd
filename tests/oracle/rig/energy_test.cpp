#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <groundtruth/rig/simulation.hpp>
#include <groundtruth/tests/oracle/rig/landings.hpp>

namespace groundtruth::rig {
namespace {

Summary landing(const LandingKind& kind, double stiffest) {
  properties::Dice dice(*rc::gen::arbitrary<std::uint64_t>());
  return play(random_landing(kind, stiffest, dice), "fast");
}

RC_GTEST_PROP(Energy, NeverRisesInAnImplicitStepWithReturnMapping, ()) {
  const auto wheels = *rc::gen::element(stability::Wheels::one, stability::Wheels::three);
  const Summary summary = landing({wheels, Integrator::implicit, Relocation::return_mapping}, 100);
  RC_ASSERT(summary.energy_rise <= 1e-12);
}

RC_GTEST_PROP(Energy, NoIntegratorLetsFrictionLeaveTheBorder, ()) {
  const LandingKind kind{
      *rc::gen::element(stability::Wheels::one, stability::Wheels::three),
      *rc::gen::element(Integrator::semi_implicit, Integrator::half_kick, Integrator::implicit),
      *rc::gen::element(Relocation::spring, Relocation::return_mapping)};
  RC_ASSERT(landing(kind, 0.3).border_violation <= 1e-9);
}

}  // namespace
}  // namespace groundtruth::rig
