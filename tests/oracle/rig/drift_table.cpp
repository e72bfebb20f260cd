#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include <groundtruth/rig/simulation.hpp>
#include <groundtruth/stability/parked.hpp>
#include <groundtruth/tests/oracle/rig/motion_tables.hpp>

namespace groundtruth::rig {
namespace {

using stability::Parked;
using stability::Wheels;

constexpr double hour = 3600;
constexpr double explicit_margin = 0.95;  // of the limit
// Beyond, rounding of positions is no longer small beside the weight: rig.md, 8.
constexpr double stiffest_implicit = 5000;

struct Line {
  int runs = 0, halted = 0, recurring = 0, slipping = 0;
  double pebble_drift_m = 0, body_drift_m = 0;  // an hour
};

void measure(const Parked& parked, Line& line) {
  const double h = stability::scenario_of(parked, 1).h;
  const auto steps = static_cast<std::uint64_t>(std::llround(hour / h));
  const Summary summary = play(stability::scenario_of(parked, steps), "fast");
  ++line.runs;
  line.halted += summary.outcome != Halt::none;
  line.recurring += summary.recurrence.has_value();
  line.slipping += summary.wheel_steps_slip > 0;
  line.pebble_drift_m = std::max(line.pebble_drift_m, 2 * summary.pebble_drift_m);
  line.body_drift_m = std::max(line.body_drift_m, 2 * summary.body_drift_m);
}

// Half a decade from one to the next, or a decade: implicit steps take longer.
std::vector<double> stiffnesses_up_to(double last, double ratio) {
  std::vector<double> all;
  for (double h_omega = 0.1; h_omega < 0.999 * last; h_omega *= ratio) all.push_back(h_omega);
  all.push_back(last);
  return all;
}

// The relocation is the default: no parked machine slips.
void print_line(double slope, Wheels wheels, Integrator integrator, double damping_ratio) {
  const bool is_implicit = integrator == Integrator::implicit;
  const double last =
      is_implicit ? stiffest_implicit : explicit_margin * stability::explicit_limit(wheels, damping_ratio);
  Line line;
  for (const double h_omega : stiffnesses_up_to(last, is_implicit ? 10 : std::sqrt(10)))
    measure({wheels, h_omega, damping_ratio, slope, integrator}, line);
  fmt::print("{:>5g} %{:>8} {:<14}{:>6g}   0.1 ...{:>8.4g}{:>6}{:>8}{:>8}{:>9}{:>14.3g}{:>14.3g}\n",
             100 * slope, wheels == Wheels::one ? 1 : 3, name_of(integrator), damping_ratio, last, line.runs,
             line.halted, line.slipping, line.recurring, line.pebble_drift_m, line.body_drift_m);
  std::fflush(stdout);
}

}  // namespace

void print_drift_table() {
  fmt::print("Parked for an hour: drift in m, twice that of the second half hour\n");
  fmt::print("{:>7}{:>8} {:<14}{:>6}  {:>16}{:>6}{:>8}{:>8}{:>9}{:>14}{:>14}\n", "slope", "wheels",
             "integrator", "zeta", "h omega", "runs", "halted", "slipped", "recurred", "pebble, m/h",
             "body, m/h");
  for (const double damping_ratio : {0.3, 0.0, 1.0})
    for (const double slope : {0.05, 0.1})
      for (const Wheels wheels : {Wheels::one, Wheels::three})
        for (const Integrator integrator :
             {Integrator::semi_implicit, Integrator::half_kick, Integrator::implicit})
          print_line(slope, wheels, integrator, damping_ratio);
}

}  // namespace groundtruth::rig
