#pragma once
// Machines that fall onto level ground, and how much energy a step of theirs made.

#include <groundtruth/rig/scenario.hpp>
#include <groundtruth/stability/parked.hpp>
#include <groundtruth/tests/properties/dice.hpp>

namespace groundtruth::rig {

struct LandingKind {
  stability::Wheels wheels = stability::Wheels::one;
  Integrator integrator = Integrator::semi_implicit;
  Relocation relocation = Relocation::spring;
};

// From 5 cm above the ground, sinking at 1 to 6 m/s, up to 60 m/s ahead and 3 m/s aside; h omega from 0.02 to
// `stiffest`, damping ratio 0 to 1, brakes from 0 to more than the wheels can bear.
Scenario random_landing(const LandingKind& kind, double stiffest, properties::Dice& dice);

}  // namespace groundtruth::rig
