#include <groundtruth/report/measured_files.hpp>

#include <fmt/format.h>

#include <groundtruth/report/stability_names.hpp>
#include <groundtruth/report/stability_report.hpp>
#include <groundtruth/report/trajectory_errors_plot.hpp>
#include <groundtruth/report/work_precision_plot.hpp>

namespace groundtruth::report {
namespace {

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') result += '"';
    result += c;
  }
  return result + "\"";
}

// Its two populations stand side by side.
std::vector<const Study*> studies_like(const Measured& measured, const Study& first) {
  std::vector<const Study*> studies;
  for (const Study& study : measured.studies)
    if (study.scene == first.scene && study.kind == first.kind) studies.push_back(&study);
  return studies;
}

}  // namespace

std::string tiers_csv(const Measured& measured) {
  std::string csv =
      "scene,ask,population,tier,asks,wrong,undecided,median_ulps,worst_ulps,ns_least,ns_median,ns_most,"
      "timed_asks,on_front,omitted,worst_ask\n";
  for (const Study& study : measured.studies)
    for (const precision::TierResult& result : study.results) {
      csv += fmt::format("{},{},{},{},{},{},{},{:g},{:g},{:.1f},{:.1f},{:.1f},{},{},{},{}\n", study.scene,
                         precision::name_of(study.kind), precision::name_of(study.population), result.tier,
                         result.asks, result.wrong, result.undecided, result.median_ulps, result.worst_ulps,
                         result.nanoseconds.least, result.nanoseconds.median, result.nanoseconds.most,
                         result.timed_asks, result.is_on_front ? "yes" : "no", quoted(result.omitted),
                         quoted(result.worst ? result.worst->ask : ""));
    }
  return csv;
}

std::string left_out_csv(const Measured& measured) {
  std::string csv = "scene,what,count,asks,ns_with,ns_without,same_answers,why\n";
  for (const precision::LeftOutWorth& worth : measured.left_out)
    csv += fmt::format("{},{},{},{},{:.1f},{:.1f},{},{}\n", worth.scene, worth.what, worth.count, worth.asks,
                       worth.with_ns.median, worth.without_ns.median, worth.same_answers ? "yes" : "no",
                       quoted(worth.why));
  return csv;
}

std::string trajectories_csv(const Measured& measured) {
  std::string csv = "motion,stiffness,integrator,relocation,h,error_m,seconds,mark,reason\n";
  for (const precision::TrajectoryRun& run : measured.trajectories)
    csv += fmt::format("{},{:g},{},{},{:g},{:g},{:.6f},{},{}\n", run.motion, run.stiffness,
                       rig::name_of(run.integrator), name_of(run.relocation), run.h, run.error_m, run.seconds,
                       precision::name_of(run.mark), quoted(run.reason));
  return csv;
}

std::vector<std::pair<std::string, std::string>> figures_of(const Measured& measured) {
  std::vector<std::pair<std::string, std::string>> figures;
  for (const Study& study : measured.studies) {
    if (study.population != precision::Population::ordinary) continue;
    const std::string kind(precision::name_of(study.kind));
    const bool is_clip = study.kind == tiers::AskKind::clip;
    figures.emplace_back(fmt::format("{}-{}.svg", kind, study.scene),
                         work_precision_plot(is_clip ? "clip" : fmt::format("{}: {}", kind, study.scene),
                                             studies_like(measured, study)));
  }
  for (const precision::MotionKind& kind : precision::motion_kinds()) {
    std::string name = kind.name;
    for (char& c : name) c = c == ' ' ? '-' : c;
    if (!measured.trajectories.empty())
      figures.emplace_back("trajectory-" + name + ".svg",
                           trajectory_errors_plot(kind.name, measured.trajectories));
  }
  if (!measured.cells.empty()) figures.emplace_back("stability.svg", svg_of(measured.grid, measured.cells));
  return figures;
}

}  // namespace groundtruth::report
