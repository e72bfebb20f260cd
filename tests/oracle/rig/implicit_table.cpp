#include <algorithm>
#include <limits>
#include <string>

#include <fmt/core.h>

#include <groundtruth/rig/simulation.hpp>
#include <groundtruth/stability/map.hpp>
#include <groundtruth/tests/bench/clock.hpp>
#include <groundtruth/tests/oracle/rig/motion_tables.hpp>

namespace groundtruth::rig {
namespace {

using stability::Fate;
using stability::Parked;
using stability::Wheels;

constexpr int parked_steps = 2000;
constexpr int stopping_steps = 400;  // 20 m/s take 306 of 1/60 s
constexpr int repetitions = 5;       // of which the fastest counts

// Of a motion's steps.
struct Effort {
  int steps = 0;
  int most_iterations = 0;  // Newton's steps and convex passes
  double mean_iterations = 0;
  int most_parts = 1;
  double border_violation = 0;
  double microseconds = std::numeric_limits<double>::infinity();  // a step

  void add(const StepRecord& record) {
    const int iterations = record.newton_steps + record.convex_passes;
    most_iterations = std::max(most_iterations, iterations);
    mean_iterations += (iterations - mean_iterations) / ++steps;
    most_parts = std::max(most_parts, record.parts);
    border_violation = std::max(border_violation, record.border_violation);
  }
  void add(const Effort& other) {
    most_iterations = std::max(most_iterations, other.most_iterations);
    mean_iterations = std::max(mean_iterations, other.mean_iterations);
    most_parts = std::max(most_parts, other.most_parts);
    border_violation = std::max(border_violation, other.border_violation);
    microseconds = std::min(microseconds, other.microseconds);
  }
};

Effort effort_of(const Scenario& scenario, int steps) {
  const auto ground = implementations::make_engine("fast")->on(scenario.scene);
  Motion motion(scenario.machine, *ground, scenario.integrator, scenario.h);
  MotionState state = scenario.state_at_start();
  const Controls controls = scenario.inputs.at(0);
  Effort effort;
  const double start = bench::nanoseconds_so_far();
  while (effort.steps < steps) {
    const StepRecord& record = motion.advance(state, controls);
    if (record.halt != Halt::none) break;
    effort.add(record);
  }
  effort.microseconds = (bench::nanoseconds_so_far() - start) / 1e3 / std::max(effort.steps, 1);
  return effort;
}

Scenario stopping(Parked parked) {
  parked.slope = 0;
  Scenario scenario = stability::scenario_of(parked, stopping_steps);
  scenario.start.velocity_in_world.x() = 20;
  return scenario;
}

// The same machine at half the explicit limit.
Parked softened(Parked parked) {
  parked.integrator = Integrator::semi_implicit;
  parked.h_omega = 0.5 * stability::explicit_limit(parked.wheels, parked.damping_ratio);
  return parked;
}

// The worst of several runs at one stiffness.
struct Line {
  std::string outcome;
  double energy_rise = 0;
  Effort implicit, of_explicit;
};

void time_both(const Scenario& implicit, const Scenario& of_explicit, int steps, Line& line) {
  for (int i = 0; i < repetitions; ++i) {
    line.implicit.add(effort_of(implicit, steps));
    line.of_explicit.add(effort_of(of_explicit, steps));
  }
}

Line parked_line(Wheels wheels, double h_omega, double damping_ratio) {
  Line line;
  Fate worst = Fate::settled;
  for (const double slope : {0.05, 0.1})
    for (const Relocation relocation : {Relocation::spring, Relocation::return_mapping}) {
      const Parked parked{wheels, h_omega, damping_ratio, slope, Integrator::implicit, relocation};
      const stability::Cell cell = stability::cell_of(parked, parked_steps);
      worst = std::max(worst, cell.fate);
      line.energy_rise = std::max(line.energy_rise, cell.energy_rise);
      time_both(scenario_of(parked, parked_steps), scenario_of(softened(parked), parked_steps), parked_steps,
                line);
    }
  line.outcome = stability::name_of(worst);
  return line;
}

bool stands(const MotionState& state) {
  return std::all_of(state.wheels.begin(), state.wheels.end(), [](const WheelState& wheel) {
    const auto* contact = std::get_if<Contact>(&wheel);
    return contact != nullptr && contact->grip == Grip::stick;
  });
}

Line stopping_line(Wheels wheels, double h_omega, double damping_ratio) {
  Line line;
  const Parked parked{wheels, h_omega, damping_ratio, 0, Integrator::implicit, Relocation::return_mapping};
  const Scenario scenario = stopping(parked);
  bool stands_at_last = false;
  const Summary summary = play(scenario, "fast", Repetitions::played,
                               [&](const Moment& moment) { stands_at_last = stands(moment.state); });
  line.outcome = summary.outcome != Halt::none ? name_of(summary.outcome)
                 : stands_at_last              ? "stands"
                                               : "slides";
  line.energy_rise = summary.energy_rise;
  time_both(scenario, stopping(softened(parked)), stopping_steps, line);
  return line;
}

void print(Wheels wheels, double damping_ratio, double times_the_limit, double h_omega, const Line& line) {
  const Effort& effort = line.implicit;
  fmt::print("{:>6}{:>6g}{:>9g}{:>10.5g}  {:<12}{:>9.2g}{:>10.2g}{:>7}{:>7.2f}{:>7}{:>9.2f}{:>8.1f}\n",
             wheels == Wheels::one ? 1 : 3, damping_ratio, times_the_limit, h_omega, line.outcome,
             effort.border_violation, line.energy_rise, effort.most_iterations, effort.mean_iterations,
             effort.most_parts, effort.microseconds, effort.microseconds / line.of_explicit.microseconds);
  std::fflush(stdout);
}

void print_table(const std::string& title, Line (*line_of)(Wheels, double, double)) {
  fmt::print("{}\n", title);
  for (const auto& words :
       {std::array{"", "", "times the", "", "", "beyond", "energy", "iter-", "", "", "us", "times"},
        {"wheels", "zeta", "limit", "h omega", "it", "border", "rise", "ations", "mean", "parts", "a step",
         "explicit"}})
    fmt::print("{:>6}{:>6}{:>10}{:>9}  {:<12}{:>9}{:>10}{:>7}{:>7}{:>7}{:>9}{:>9}\n", words[0], words[1],
               words[2], words[3], words[4], words[5], words[6], words[7], words[8], words[9], words[10],
               words[11]);
  for (const Wheels wheels : {Wheels::one, Wheels::three})
    for (const double damping_ratio : {0.0, 0.1, 0.3, 1.0})
      for (const double times_the_limit : {0.1, 1.0, 10.0, 100.0, 1e3, 5e3, 1e4, 2e4}) {
        const double h_omega = times_the_limit * stability::explicit_limit(wheels, damping_ratio);
        print(wheels, damping_ratio, times_the_limit, h_omega, line_of(wheels, h_omega, damping_ratio));
      }
  fmt::print("\n");
}

}  // namespace

void print_implicit_table() {
  print_table("The implicit integrator, parked on 5 and 10 %, both relocations, 2,000 steps: the worst",
              parked_line);
  print_table("The same, braking from 20 m/s to rest on level ground, return mapping, 400 steps",
              stopping_line);
}

}  // namespace groundtruth::rig
