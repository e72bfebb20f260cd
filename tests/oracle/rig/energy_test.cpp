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

// Proved for one wheel that does not turn only (proofs-notes/rig.md, 2); of three, 0.53 m g 1 m was seen.
RC_GTEST_PROP(Energy, NeverRisesInAnImplicitStepWithReturnMapping, ()) {
  const LandingKind kind{stability::Wheels::one, Integrator::implicit, Relocation::return_mapping};
  RC_ASSERT(landing(kind, 100).energy_rise <= 1e-12);
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
