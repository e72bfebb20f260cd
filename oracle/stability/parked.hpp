#pragma once
// A machine left on a slope with its brakes on: the case by which an integrator is judged.

#include <cstdint>

#include <groundtruth/rig/scenario.hpp>

namespace groundtruth::stability {

enum class Wheels { one, three };

// 1,200 kg, every wheel alike. A machine on one wheel does not turn; that on three does.
struct Parked {
  Wheels wheels = Wheels::one;
  double h_omega = 0.1;        // h sqrt(sum of k over the mass): how stiff, in steps
  double damping_ratio = 0.3;  // d over 2 sqrt(k m)
  double slope = 0.05;         // tangent, uphill ahead
  rig::Integrator integrator = rig::Integrator::semi_implicit;
  Relocation relocation = Relocation::spring;
};

// The frequency is 20 rad/s while that makes steps of 1/60 s or less; then the steps are of 1/60 s and the
// frequency rises. The machine comes to rest in its first step, with its struts as compressed as its
// weight will hold them and its springs slack along the ground; three wheels bear a third each.
rig::Scenario scenario_of(const Parked& parked, std::uint64_t steps);

// The h omega up to which explicit integrators are stable: 2 (sqrt(1 + z^2) - z) for the machine's fastest
// mode, whose frequency is `ratio` times omega and whose damping ratio is z = `ratio` times that of the case.
double explicit_limit(Wheels wheels, double damping_ratio);

}  // namespace groundtruth::stability
