#include <algorithm>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <thread>

#include <fmt/core.h>

#include <groundtruth/report/stability_report.hpp>
#include <groundtruth/stability/shared_out.hpp>

#include "progress_bar.hpp"
#include "subcommand.hpp"

namespace groundtruth::cli {
namespace {

enum class Extent { whole, quick };

struct Options {
  Extent extent = Extent::whole;
  double slope = 0.05;
  std::uint64_t seed = 1;
  unsigned jobs = std::max(1U, std::thread::hardware_concurrency());
  std::string csv, svg;  // files; empty: none
};

stability::Grid grid_of(const Options& options) {
  return options.extent == Extent::quick ? stability::coarse_grid(options.slope)
                                         : stability::fine_grid(options.slope);
}

void write(const std::string& path, const std::string& text) {
  if (path.empty()) return;
  std::ofstream file(path);
  file << text;
  if (!file.flush()) throw std::runtime_error(path + ": cannot be written");
}

std::vector<stability::Ordeal> ordeals_for(const Options& options, ProgressBar& bar) {
  std::vector<stability::Extreme> extremes = stability::chosen_extremes();
  const std::uint64_t random = options.extent == Extent::quick ? 100 : 3000;
  const std::uint64_t steps = options.extent == Extent::quick ? 100 : 1000;
  for (std::uint64_t i = 0; i < random; ++i) extremes.push_back(stability::random_extreme(options.seed + i));
  std::vector<stability::Ordeal> ordeals(extremes.size());
  stability::share_out(
      extremes.size(), options.jobs,
      [&](std::size_t i) { ordeals[i] = stability::ordeal_of(extremes[i], steps); },
      [&](std::uint64_t done, std::uint64_t all) { bar.show("extremes", done, all); });
  return ordeals;
}

Exit run(const Options& options) {
  const stability::Grid grid = grid_of(options);
  ProgressBar bar;
  const auto cells = stability::map_of(
      grid, options.jobs, [&](std::uint64_t done, std::uint64_t all) { bar.show("maps", done, all); });
  bar.clear();
  fmt::print("Parked on a slope of {:g} %, {} steps each\n\n{}\n", 100 * grid.slope, grid.steps,
             report::table_of(grid, cells));
  write(options.csv, report::csv_of(cells));
  write(options.svg, report::svg_of(grid, cells));
  const auto ordeals = ordeals_for(options, bar);
  bar.clear();
  fmt::print("{}", report::table_of(ordeals));
  const bool is_sound = std::all_of(ordeals.begin(), ordeals.end(),
                                    [](const stability::Ordeal& ordeal) { return ordeal.all_is_finite; });
  return is_sound ? Exit::agrees : Exit::disagrees;
}

}  // namespace

Subcommand add_stability(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "stability", "Maps which parked machines stand still, and tries extreme machines, grounds and steps");
  const auto options = std::make_shared<Options>();
  command->add_flag_callback(
      "--quick", [options] { options->extent = Extent::quick; }, "Coarse maps and few extremes: seconds");
  command->add_option("--slope", options->slope, "Tangent of the slope of the maps")
      ->check(CLI::Range(-9.0, 9.0))
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Of the random extremes")->capture_default_str();
  command->add_option("--jobs", options->jobs, "Threads")
      ->check(CLI::Range(1U, 1024U))
      ->capture_default_str();
  command->add_option("--csv", options->csv, "Write the maps to this file, a line a machine");
  command->add_option("--svg", options->svg, "Draw the maps into this file");
  return {command, [options] { return run(*options); }};
}

}  // namespace groundtruth::cli
