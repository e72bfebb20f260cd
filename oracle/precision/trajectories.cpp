#include <groundtruth/precision/trajectories.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <groundtruth/precision/clock.hpp>
#include <groundtruth/rig/builtin_scenarios.hpp>
#include <groundtruth/rig/simulation.hpp>

namespace groundtruth::precision {
namespace {

constexpr double longest_step = 1.0 / 64;  // s: near the limit of explicit integrators on the stiff gear
constexpr double reference_refinement = 16;
constexpr double blown_up_rise = 0.1;   // in a step, in parts of m g 1 m
constexpr double blown_up_error = 0.1;  // m
constexpr double quick_run = 0.02;      // s: of these the best of three counts

struct Motion {
  MotionKind kind;
  const char* scenario;
  double duration;  // s
  double speed;     // m/s along x at the start; negative: the scenario's
};

constexpr const char* refined = "the half-kick integrator with return mapping at 1/16 of the shortest step";

const std::array<Motion, 4>& motions() {
  static const std::array<Motion, 4> all{{
      {{"smooth sliding", "three braked wheels down a slope of 60 %, 1 s", refined}, "slide", 1, -1},
      {{"full stop", "one wheel brakes from 4 m/s to rest and stands, 2 s", refined}, "stop-one", 2, 4},
      {{"landing with bounce", "three wheels touch down with a sink of 3 m/s, 2 s", refined},
       "land-3",
       2,
       -1},
      {{"parked drift", "three braked wheels left on a slope of 5 %, 4 s", refined}, "parked-5", 4, -1},
  }};
  return all;
}

rig::Scenario scenario_of(const Motion& motion, double stiffness, Relocation relocation) {
  rig::Scenario scenario = *rig::find_builtin_scenario(motion.scenario);
  scenario.duration = motion.duration;
  if (motion.speed >= 0) scenario.start.velocity_in_world = {motion.speed, 0, 0};
  for (rig::MountedWheel& mounted : scenario.machine.wheels) {
    Wheel& wheel = mounted.wheel;
    wheel.k_xy *= stiffness;
    wheel.k_z *= stiffness;
    wheel.d_xy *= std::sqrt(stiffness);
    wheel.d_z *= std::sqrt(stiffness);
    wheel.relocation = relocation;
  }
  return scenario;
}

struct Played {
  Eigen::Vector3d end = Eigen::Vector3d::Zero();
  rig::Summary summary;
  double seconds = 0;
};

Played play(rig::Scenario scenario, rig::Integrator integrator, double h) {
  scenario.integrator = integrator;
  scenario.h = h;
  Played played{scenario.start.position_in_world, {}, 0};
  const double start = thread_seconds();
  played.summary = rig::play(scenario, "fast", rig::Repetitions::played, [&](const rig::Moment& moment) {
    played.end = moment.state.body.position_in_world;
  });
  played.seconds = thread_seconds() - start;
  return played;
}

RunMark mark_of(const rig::Summary& summary, double error, bool should_stand) {
  if (summary.outcome != rig::Halt::none) return RunMark::halted;
  if (summary.energy_rise > blown_up_rise && !(error < blown_up_error)) return RunMark::blown_up;
  return should_stand && summary.pebble_drift_m > 0 ? RunMark::creeping : RunMark::none;
}

TrajectoryRun run_of(const Motion& motion, const rig::Scenario& scenario, rig::Integrator integrator,
                     double h, const Eigen::Vector3d& right_end) {
  Played played = play(scenario, integrator, h);
  for (int again = 0; again < 2 && played.seconds < quick_run; ++again)
    played.seconds = std::min(played.seconds, play(scenario, integrator, h).seconds);
  TrajectoryRun run;
  run.motion = motion.kind.name;
  run.integrator = integrator;
  run.relocation = scenario.machine.wheels.front().wheel.relocation;
  run.h = h;
  run.error_m = (played.end - right_end).norm();
  run.seconds = played.seconds;
  run.mark = mark_of(played.summary, run.error_m, motion.kind.name == "parked drift");
  if (played.summary.outcome != rig::Halt::none) run.reason = rig::name_of(played.summary.outcome);
  return run;
}

}  // namespace

std::string_view name_of(RunMark mark) {
  constexpr std::array<std::string_view, 4> names{"", "creeping", "blown up", "halted"};
  return names[static_cast<std::size_t>(mark)];
}

std::vector<MotionKind> motion_kinds() {
  std::vector<MotionKind> kinds;
  for (const Motion& motion : motions()) kinds.push_back(motion.kind);
  return kinds;
}

std::vector<TrajectoryRun> run_trajectories(
    const TrajectoryPlan& plan, const std::function<void(std::uint64_t done, std::uint64_t all)>& progress) {
  std::vector<TrajectoryRun> runs;
  const std::uint64_t all = motions().size() * plan.stiffnesses.size() * 2;
  std::uint64_t done = 0;
  const double shortest = std::ldexp(longest_step, -plan.halvings);
  for (const Motion& motion : motions())
    for (const double stiffness : plan.stiffnesses) {
      const Played reference = play(scenario_of(motion, stiffness, Relocation::return_mapping),
                                    rig::Integrator::half_kick, shortest / reference_refinement);
      for (const Relocation relocation : {Relocation::spring, Relocation::return_mapping}) {
        const rig::Scenario scenario = scenario_of(motion, stiffness, relocation);
        for (const rig::Integrator integrator :
             {rig::Integrator::semi_implicit, rig::Integrator::half_kick, rig::Integrator::implicit})
          for (int halving = 0; halving <= plan.halvings; ++halving) {
            runs.push_back(
                run_of(motion, scenario, integrator, std::ldexp(longest_step, -halving), reference.end));
            runs.back().stiffness = stiffness;
          }
        progress(++done, all);
      }
    }
  return runs;
}

}  // namespace groundtruth::precision
