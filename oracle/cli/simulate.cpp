#include <fstream>
#include <memory>
#include <optional>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <groundtruth/report/simulation_report.hpp>
#include <groundtruth/report/trajectory_csv.hpp>
#include <groundtruth/report/trajectory_plot.hpp>
#include <groundtruth/rig/builtin_scenarios.hpp>
#include <groundtruth/rig/scenario_text.hpp>

#include "subcommand.hpp"

namespace groundtruth::cli {
namespace {

enum class Form { table, json };

struct Options {
  std::string scenario;  // a file or a built-in name; none: a list of these
  std::string engine = "fast";
  std::optional<double> duration;
  std::optional<double> h;
  std::optional<std::string> integrator;
  std::optional<std::string> relocation;
  std::optional<std::string> csv;
  std::optional<std::string> plot;
  std::uint64_t every = 1;
  rig::Repetitions repetitions = rig::Repetitions::skipped;
  Form form = Form::table;
};

Exit list() {
  for (const rig::Scenario& scenario : rig::builtin_scenarios())
    fmt::print("{:<14}{}\n", scenario.name, scenario.description);
  return Exit::agrees;
}

rig::Scenario scenario_for(const Options& options) {
  const auto* builtin = rig::find_builtin_scenario(options.scenario);
  rig::Scenario scenario = builtin ? *builtin : rig::read_scenario_file(options.scenario);
  if (options.duration) scenario.duration = *options.duration;
  if (options.h) scenario.h = *options.h;
  if (options.integrator) scenario.integrator = *rig::integrator_named(*options.integrator);
  if (options.relocation) {
    const bool maps = *options.relocation == "return-mapping";
    for (rig::MountedWheel& mounted : scenario.machine.wheels)
      mounted.wheel.relocation = maps ? Relocation::return_mapping : Relocation::spring;
  }
  return scenario;
}

std::ofstream open_output(const std::string& file) {
  std::ofstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error(file + ": cannot be written");
  return stream;
}

void close_output(std::ofstream& stream, const std::string& file) {
  stream.close();
  if (!stream) throw std::runtime_error(file + ": cannot be written");
}

rig::Summary play(const rig::Scenario& scenario, const Options& options) {
  std::optional<std::ofstream> csv;
  std::optional<std::ofstream> svg;
  if (options.csv) csv = open_output(*options.csv);
  if (options.plot) svg = open_output(*options.plot);
  if (csv) report::write_csv_header(*csv, scenario.machine.wheels.size());
  report::TrajectoryPlot plot(scenario);
  const auto observe = [&](const rig::Moment& moment) {
    if (csv && moment.state.steps % options.every == 0) report::write_csv_row(*csv, moment);
    if (svg) plot.add(moment);
  };
  const bool is_observed = csv || svg;
  const rig::Summary summary =
      rig::play(scenario, options.engine, options.repetitions,
                is_observed ? std::function<void(const rig::Moment&)>(observe) : nullptr);
  if (csv) close_output(*csv, *options.csv);
  if (svg) {
    *svg << plot.svg();
    close_output(*svg, *options.plot);
  }
  return summary;
}

Exit refuse(const std::string& problem) {
  fmt::print(stderr, "groundtruth simulate: {}\n", problem);
  return Exit::usage;
}

Exit run(const Options& options) {
  if (options.scenario.empty()) return list();
  if (implementations::make_engine(options.engine) == nullptr) {
    return refuse(fmt::format("--engine: {} is none of {}, as-written:ERRATUM,...", options.engine,
                              fmt::join(implementations::engine_names(), ", ")));
  }
  const rig::Scenario scenario = scenario_for(options);
  if (!rig::is_countable(scenario.duration, scenario.h)) {
    return refuse(
        fmt::format("--duration: {} s are more than 2^53 steps of {} s", scenario.duration, scenario.h));
  }
  const rig::Summary summary = play(scenario, options);
  const bool is_json = options.form == Form::json;
  fmt::print("{}", is_json ? report::json_of(scenario, summary) : report::table_of(scenario, summary));
  return Exit::agrees;
}

}  // namespace

Subcommand add_simulate(CLI::App& program) {
  CLI::App* command = program.add_subcommand("simulate", "Plays a scenario: a body on wheels over a scene");
  const auto options = std::make_shared<Options>();
  command->add_option("scenario", options->scenario,
                      "A scenario file or the name of a built-in scenario; none: a list of these");
  command->add_option("--duration", options->duration, "Seconds to play")
      ->check(CLI::Range(0.0, std::numeric_limits<double>::max()));
  command->add_option("--h", options->h, "Length of a step, s")
      ->check(CLI::Range(std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max()));
  command->add_option("--integrator", options->integrator, "semi-implicit, half-kick or implicit")
      ->check(CLI::IsMember({"semi-implicit", "half-kick", "implicit"}));
  command->add_option("--relocation", options->relocation, "Of all wheels: spring or return-mapping")
      ->check(CLI::IsMember({"spring", "return-mapping"}));
  command->add_option("--engine", options->engine,
                      "Who answers the steps: exact, definition, fast, double, as-written:...");
  command->add_option("--csv", options->csv, "Write a row a step to this file");
  command->add_option("--every", options->every, "Rows of --csv: only every so many steps")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 53));
  command->add_option("--plot", options->plot, "Draw height, speed, energy and wheels to this SVG file");
  command->add_flag_callback(
      "--every-step", [options] { options->repetitions = rig::Repetitions::played; },
      "Also play steps that are known to the last bit, because the motion repeats itself");
  command->add_flag_callback(
      "--json", [options] { options->form = Form::json; }, "One JSON object");
  return {command, [options] { return run(*options); }};
}

}  // namespace groundtruth::cli
