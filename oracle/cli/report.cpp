#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <thread>

#include <fmt/core.h>

#include <groundtruth/cases/builtin_scenes.hpp>
#include <groundtruth/cases/shape_parts.hpp>
#include <groundtruth/report/measured_files.hpp>
#include <groundtruth/report/page.hpp>

#include "progress_bar.hpp"
#include "subcommand.hpp"
#include "validation_files.hpp"

namespace groundtruth::cli {
namespace {

enum class Extent { whole, quick };
enum class Form { table, json };

struct Options {
  std::string out;  // a folder
  Extent extent = Extent::whole;
  Form form = Form::table;
  std::uint64_t seed = 1;
  std::string compare;  // a report.json of before; empty: none
  double threshold = 0.5;
};

// How much is measured.
struct Amount {
  std::size_t asks;  // of each sample
  precision::Effort effort;
  std::vector<std::string_view> step_scenes;  // none: all
  std::size_t left_out_asks;
  precision::TrajectoryPlan trajectories;
  stability::Grid grid;
};

constexpr double slope = 0.05;  // of the stability maps

Amount amount_of(const Options& options) {
  if (options.extent == Extent::quick)
    return {300, {0.03, 0.003, 5}, {"ramp", "town"}, 500, {{1, 16}, 5}, stability::coarse_grid(slope)};
  return {3000, {0.3, 0.03, 9}, {}, 5000, {{1, 16, 256}, 7}, stability::fine_grid(slope)};
}

bool is_stepped_on(const Amount& amount, std::string_view scene) {
  return amount.step_scenes.empty() ||
         std::find(amount.step_scenes.begin(), amount.step_scenes.end(), scene) != amount.step_scenes.end();
}

// A sample to measure tiers on.
struct Errand {
  const cases::BuiltinScene* scene;
  tiers::AskKind kind;
};

std::vector<Errand> errands_of(const Amount& amount) {
  std::vector<Errand> errands;
  for (const auto& scene : cases::builtin_scenes()) errands.push_back({&scene, tiers::AskKind::entry});
  errands.push_back({&cases::builtin_scenes().front(), tiers::AskKind::clip});  // which needs no scene
  for (const auto& scene : cases::builtin_scenes())
    if (is_stepped_on(amount, scene.name)) errands.push_back({&scene, tiers::AskKind::step});
  return errands;
}

void measure_tiers(const Options& options, const Amount& amount, ProgressBar& bar,
                   report::Measured& measured) {
  const std::vector<Errand> errands = errands_of(amount);
  for (std::size_t i = 0; i < errands.size(); ++i) {
    bar.show("tiers", i, errands.size());
    const std::vector<Scene> pack = errands[i].scene->build();
    for (const auto population : {precision::Population::ordinary, precision::Population::hostile}) {
      report::Study study{std::string(errands[i].scene->name), errands[i].kind, population, 0, 0, {}};
      for (const Scene& scene : pack) study.leaves += cases::leaf_count(scene.shape);
      const auto sample =
          precision::draw(study.scene, pack, study.kind, population, options.seed, amount.asks);
      study.asks = sample.cases.size();
      study.results = precision::measure(sample, amount.effort);
      measured.studies.push_back(std::move(study));
    }
  }
}

void measure_left_out(const Options& options, const Amount& amount, ProgressBar& bar,
                      report::Measured& measured) {
  const auto& scenes = cases::builtin_scenes();
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    bar.show("left out", i, scenes.size());
    const auto worths =
        precision::worth_of_left_out(std::string(scenes[i].name), scenes[i].build(), options.seed,
                                     amount.left_out_asks, amount.effort.rounds);
    measured.left_out.insert(measured.left_out.end(), worths.begin(), worths.end());
  }
}

void note_omissions(const Amount& amount, report::Measured& measured) {
  for (const auto& tier : tiers::tiers())
    for (const auto kind : {tiers::AskKind::entry, tiers::AskKind::clip, tiers::AskKind::step})
      if (const auto omission = tier->omission(kind))
        measured.omissions.push_back(
            {fmt::format("{} on {} asks", tier->name(), precision::name_of(kind)), omission->reason});
  for (const report::Study& study : measured.studies)
    if (study.asks == 0)
      measured.omissions.push_back({fmt::format("{} asks of {} on {}", precision::name_of(study.population),
                                                precision::name_of(study.kind), study.scene),
                                    "none came up"});
  for (const auto& scene : cases::builtin_scenes())
    if (!is_stepped_on(amount, scene.name))
      measured.omissions.push_back(
          {fmt::format("step asks on {}", scene.name), "left out of a quick report"});
  for (const auto& run : measured.trajectories)
    if (run.mark == precision::RunMark::halted)
      measured.omissions.push_back(
          {fmt::format("{}, {}, {} relocation at h = {:g} s, springs x {:g}: stopped before its end",
                       run.motion, rig::name_of(run.integrator),
                       run.relocation == Relocation::spring ? "spring" : "return-mapping", run.h,
                       run.stiffness),
           run.reason});
}

report::Measured measure(const Options& options) {
  const auto start = std::chrono::steady_clock::now();
  const Amount amount = amount_of(options);
  report::Measured measured;
  measured.machine = precision::this_machine();
  measured.extent = options.extent == Extent::quick ? "quick" : "full";
  measured.seed = options.seed;
  ProgressBar bar;
  measure_tiers(options, amount, bar, measured);
  measure_left_out(options, amount, bar, measured);
  measured.trajectories = precision::run_trajectories(
      amount.trajectories, [&](std::uint64_t done, std::uint64_t all) { bar.show("motions", done, all); });
  measured.grid = amount.grid;
  measured.cells =
      stability::map_of(amount.grid, std::max(1U, std::thread::hardware_concurrency()),
                        [&](std::uint64_t done, std::uint64_t all) { bar.show("maps", done, all); });
  bar.clear();
  note_omissions(amount, measured);
  measured.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return measured;
}

void write_files(const report::Measured& measured, const std::string& folder) {
  const std::filesystem::path out(folder);
  const auto write = [&](const std::string& name, const std::string& text) {
    write_text((out / name).string(), text);
  };
  write("report.html", report::page_of(measured));
  write("report.json", report::json_of(measured));
  write("tiers.csv", report::tiers_csv(measured));
  write("left-out.csv", report::left_out_csv(measured));
  write("trajectories.csv", report::trajectories_csv(measured));
  for (const auto& [name, svg] : report::figures_of(measured)) write(name, svg);
}

Exit compare(const std::vector<precision::TierFigure>& before, const report::Measured& measured,
             const Options& options) {
  const auto found = precision::regressions(before, report::tier_figures_of(measured), options.threshold);
  std::FILE* const to = options.form == Form::json ? stderr : stdout;
  for (const precision::Regression& regression : found)
    fmt::print(to, "{} {}: {} {:.3g} -> {:.3g}\n", regression.study, regression.tier, regression.what,
               regression.before, regression.now);
  fmt::print(to, "{} of {} figures are worse than in {} by more than {:g} %\n", found.size(), before.size(),
             options.compare, 100 * options.threshold);
  return found.empty() ? Exit::agrees : Exit::disagrees;
}

Exit run(const Options& options) {
  // What cannot be read or written is told before anything is measured.
  std::vector<precision::TierFigure> before;
  if (!options.compare.empty()) before = report::read_tier_figures(options.compare);
  std::filesystem::create_directories(options.out);
  const report::Measured measured = measure(options);
  write_files(measured, options.out);
  if (options.form == Form::json)
    fmt::print("{}", report::json_of(measured));
  else
    fmt::print("{}\n{}/report.html, {:.0f} s\n", report::summary_of(measured), options.out, measured.seconds);
  return options.compare.empty() ? Exit::agrees : compare(before, measured, options);
}

}  // namespace

Subcommand add_report(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "report", "Measures error against run time for every kind of arithmetic, and writes a page about it");
  const auto options = std::make_shared<Options>();
  command->add_option("--out", options->out, "The folder for report.html and the files behind it")
      ->required();
  command->add_flag_callback(
      "--quick", [options] { options->extent = Extent::quick; }, "Fewer asks, scenes and machines: a minute");
  command->add_flag_callback(
      "--json", [options] { options->form = Form::json; }, "Print report.json instead of a table");
  command->add_option("--seed", options->seed, "Of the asks")->capture_default_str();
  command->add_option("--compare", options->compare, "An older report.json: exit 1 if a tier became worse");
  command->add_option("--threshold", options->threshold, "By what share a figure may be worse than before")
      ->check(CLI::Range(0.0, 1e9))
      ->capture_default_str();
  return {command, [options] { return run(*options); }};
}

}  // namespace groundtruth::cli
