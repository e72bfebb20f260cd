#include <groundtruth/stability/map.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <groundtruth/rig/simulation.hpp>
#include <groundtruth/stability/shared_out.hpp>

namespace groundtruth::stability {
namespace {

constexpr double blown_up_rise = 0.1;  // m g 1 m

// Watches a run for what its summary does not say.
class Watch {
 public:
  Watch(const rig::Scenario& scenario, std::uint64_t steps)
      : steps_(steps), weight_(scenario.machine.mass * 9.81) {}

  void see(const rig::Moment& moment) {
    if (seen_++ == 0) first_energy_ = moment.energy;
    highest_ = std::max(highest_, moment.energy - first_energy_);
    if (2 * seen_ < steps_) return;
    const auto& body = moment.state.body;
    const double speed = std::max(body.velocity_in_world.norm(), body.angular_velocity_in_world.norm());
    double& fastest = 4 * seen_ < 3 * steps_ ? fastest_in_third_quarter_ : fastest_in_last_quarter_;
    fastest = std::max(fastest, speed);
    for (const WheelState& wheel : moment.state.wheels) leaves_ |= std::holds_alternative<Free>(wheel);
  }

  bool blew_up() const { return !(highest_ < blown_up_rise * weight_); }
  bool leaves_the_ground() const { return leaves_; }
  bool is_calm() const {
    return fastest_in_last_quarter_ < 1e-5 || fastest_in_last_quarter_ < 0.99 * fastest_in_third_quarter_;
  }

 private:
  std::uint64_t steps_;
  double weight_;
  std::uint64_t seen_ = 0;
  double first_energy_ = 0, highest_ = 0;
  double fastest_in_third_quarter_ = 0, fastest_in_last_quarter_ = 0;
  bool leaves_ = false;
};

Fate fate_of(const Watch& watch, const rig::Summary& summary) {
  if (summary.outcome == rig::Halt::not_finite || watch.blew_up()) return Fate::blown_up;
  if (summary.outcome != rig::Halt::none) return Fate::gave_a_reason;
  if (watch.leaves_the_ground() || std::isinf(summary.pebble_drift_m)) return Fate::chattering;
  if (summary.pebble_drift_m > 0) return Fate::creeping;
  return summary.recurrence || watch.is_calm() ? Fate::settled : Fate::swinging;
}

std::vector<Parked> cases_of(const Grid& grid) {
  std::vector<Parked> cases;
  for (const auto integrator :
       {rig::Integrator::semi_implicit, rig::Integrator::half_kick, rig::Integrator::implicit})
    for (const auto wheels : {Wheels::one, Wheels::three})
      for (const auto relocation : {Relocation::spring, Relocation::return_mapping})
        for (const double damping : grid.damping_ratios)
          for (const double h_omega : grid.h_omegas)
            cases.push_back({wheels, h_omega, damping, grid.slope, integrator, relocation});
  return cases;
}

std::vector<double> powers_of_ten(double first, double last, int per_decade) {
  std::vector<double> values;
  const int count = static_cast<int>(std::lround((last - first) * per_decade));
  for (int i = 0; i <= count; ++i)
    values.push_back(std::pow(10, first + static_cast<double>(i) / per_decade));
  return values;
}

}  // namespace

Grid fine_grid(double slope) {
  return {powers_of_ten(-2, 5, 4), {0, 0.1, 0.2, 0.3, 0.5, 0.7, 1, 1.5, 2}, slope, 3000};
}

Grid coarse_grid(double slope) { return {powers_of_ten(-2, 5, 2), {0, 0.3, 1}, slope, 400}; }

std::string_view name_of(Fate fate) {
  constexpr std::array<std::string_view, 6> names{"settled",    "swinging", "creeping",
                                                  "chattering", "blown up", "gave a reason"};
  return names[static_cast<std::size_t>(fate)];
}

Cell cell_of(const Parked& parked, std::uint64_t steps) {
  const rig::Scenario scenario = scenario_of(parked, steps);
  Watch watch(scenario, steps);
  const rig::Summary summary = rig::play(scenario, "fast", rig::Repetitions::skipped,
                                         [&](const rig::Moment& moment) { watch.see(moment); });
  Cell cell{parked, fate_of(watch, summary), summary.outcome,
            0,      summary.energy_rise,     summary.most_newton_steps};
  if (summary.outcome == rig::Halt::none)
    cell.metres_per_hour = summary.body_drift_m / (scenario.duration / 2) * 3600;
  return cell;
}

std::vector<Cell> map_of(const Grid& grid, unsigned jobs,
                         const std::function<void(std::uint64_t, std::uint64_t)>& progress) {
  const std::vector<Parked> cases = cases_of(grid);
  std::vector<Cell> cells(cases.size());
  share_out(
      cases.size(), jobs, [&](std::size_t i) { cells[i] = cell_of(cases[i], grid.steps); }, progress);
  return cells;
}

}  // namespace groundtruth::stability
