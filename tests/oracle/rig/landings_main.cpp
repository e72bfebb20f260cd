// landings COUNT [SEED]: so many random landings of each kind; the largest energy that a step made, in parts
// of m g 1 m.

#include <algorithm>
#include <cstdlib>

#include <fmt/core.h>

#include <groundtruth/rig/simulation.hpp>
#include <groundtruth/tests/oracle/rig/landings.hpp>

namespace {

using namespace groundtruth;

void land(const rig::LandingKind& kind, std::uint64_t count, std::uint64_t seed) {
  properties::Dice dice(seed);
  double worst = 0, beyond_border = 0;
  std::uint64_t steps = 0, broken = 0, unsolved = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const double stiffest = kind.integrator == rig::Integrator::implicit ? 100 : 1.0 / 3;
    const rig::Summary summary = rig::play(rig::random_landing(kind, stiffest, dice), "fast");
    worst = std::max(worst, summary.energy_rise);
    beyond_border = std::max(beyond_border, summary.border_violation);
    steps += summary.steps;
    if (summary.outcome == rig::Halt::wheel_broken) ++broken;
    if (summary.outcome == rig::Halt::not_solved) ++unsolved;
  }
  fmt::print(
      "{:<14}{} {:<15} {} landings, {} steps, {} broke, {} not solved: rise {:.3g}, beyond border {:.3g}\n",
      rig::name_of(kind.integrator), kind.wheels == stability::Wheels::one ? 1 : 3,
      kind.relocation == Relocation::spring ? "spring" : "return-mapping", count, steps, broken, unsolved,
      worst, beyond_border);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const std::uint64_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1000;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  for (const auto integrator :
       {rig::Integrator::semi_implicit, rig::Integrator::half_kick, rig::Integrator::implicit})
    for (const auto relocation : {Relocation::spring, Relocation::return_mapping})
      for (const auto wheels : {stability::Wheels::one, stability::Wheels::three})
        land({wheels, integrator, relocation}, count, seed);
}
