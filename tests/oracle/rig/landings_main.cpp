// landings COUNT [SEED [INTEGRATOR]]: so many random landings of each kind; the largest energy that a step
// made, in parts of m g 1 m. `landings 1 S`, with the seed that a line ends with, lands the worst of its kind
// again.

#include <algorithm>
#include <cstdlib>

#include <fmt/core.h>

#include <groundtruth/rig/simulation.hpp>
#include <groundtruth/tests/oracle/rig/landings.hpp>

namespace {

using namespace groundtruth;

constexpr double free_of_rises = 1e-12;  // m g 1 m

struct Tally {
  std::uint64_t landings = 0, steps = 0, rising = 0, broken = 0, unsolved = 0;
  double worst_rise = 0, beyond_border = 0;
  std::uint64_t worst_seed = 0;

  void add(const rig::Summary& summary, std::uint64_t seed) {
    ++landings;
    steps += summary.steps;
    rising += summary.energy_rise > free_of_rises;
    broken += summary.outcome == rig::Halt::wheel_broken;
    unsolved += summary.outcome == rig::Halt::not_solved;
    beyond_border = std::max(beyond_border, summary.border_violation);
    if (landings > 1 && summary.energy_rise <= worst_rise) return;
    worst_rise = summary.energy_rise;
    worst_seed = seed;
  }
};

void land(const rig::LandingKind& kind, std::uint64_t count, std::uint64_t first_seed) {
  const double stiffest = kind.integrator == rig::Integrator::implicit ? 100 : 1.0 / 3;
  Tally tally;
  for (std::uint64_t seed = first_seed; seed < first_seed + count; ++seed) {
    properties::Dice dice(seed);
    tally.add(rig::play(rig::random_landing(kind, stiffest, dice), "fast"), seed);
  }
  fmt::print("{:<14}{:>6} {:<15}{:>9}{:>10}{:>7}{:>9}{:>9}{:>12.3g}{:>12.3g}{:>9}\n",
             rig::name_of(kind.integrator), kind.wheels == stability::Wheels::one ? 1 : 3,
             kind.relocation == Relocation::spring ? "spring" : "return-mapping", tally.landings, tally.steps,
             tally.broken, tally.unsolved, tally.rising, tally.worst_rise, tally.beyond_border,
             tally.worst_seed);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const std::uint64_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1000;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  const auto only = argc > 3 ? rig::integrator_named(argv[3]) : std::nullopt;
  fmt::print("{:<14}{:>6} {:<15}{:>9}{:>10}{:>7}{:>9}{:>9}{:>12}{:>12}{:>9}\n", "integrator", "wheels",
             "relocation", "landings", "steps", "broke", "unsolved", "> 1e-12", "worst rise", "past border",
             "seed");
  for (const auto integrator :
       {rig::Integrator::implicit, rig::Integrator::semi_implicit, rig::Integrator::half_kick}) {
    if (only && integrator != *only) continue;
    for (const auto relocation : {Relocation::return_mapping, Relocation::spring})
      for (const auto wheels : {stability::Wheels::one, stability::Wheels::three})
        land({wheels, integrator, relocation}, count, seed);
  }
}
