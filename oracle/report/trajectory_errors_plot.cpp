#include <groundtruth/report/trajectory_errors_plot.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <groundtruth/report/chart.hpp>
#include <groundtruth/report/html.hpp>

namespace groundtruth::report {
namespace {

using precision::RunMark;
using precision::TrajectoryRun;

constexpr double panel_width = 455, inner_left = 58, inner_width = 376, top = 66, inner_height = 250,
                 bottom = 46;
constexpr double height = top + inner_height + bottom;
constexpr double least_error = 1e-17, most_error = 1e6;

Hue hue_of(rig::Integrator integrator) {
  if (integrator == rig::Integrator::semi_implicit) return Hue::machine;
  return integrator == rig::Integrator::half_kick ? Hue::ours : Hue::engines;
}

double shown_error(double error) {
  return std::isfinite(error) ? std::clamp(error, least_error, most_error) : most_error;
}

// All panels of a figure share their scales; both axes are logarithmic.
struct Scales {
  double first_ns = 1e300, last_ns = 0, least = most_error, most = least_error;

  explicit Scales(const std::vector<TrajectoryRun>& runs) {
    for (const TrajectoryRun& run : runs) {
      first_ns = std::min(first_ns, 1e9 * run.seconds);
      last_ns = std::max(last_ns, 1e9 * run.seconds);
      least = std::min(least, shown_error(run.error_m));
      most = std::max(most, shown_error(run.error_m));
    }
    first_ns = std::pow(10, std::floor(std::log10(first_ns)));
    last_ns = std::pow(10, std::ceil(std::log10(last_ns)));
    least = std::pow(10, std::floor(std::log10(least)));
    most = std::max(10 * least, std::pow(10, std::ceil(std::log10(most))));
  }
  double x(double ns) const { return inner_width * std::log(ns / first_ns) / std::log(last_ns / first_ns); }
  double y(double error) const { return inner_height * std::log(most / error) / std::log(most / least); }
};

class Panel {
 public:
  Panel(Chart& chart, const Scales& scales, double left)
      : chart_(chart), scales_(scales), left_(left + inner_left) {}

  void draw(const std::vector<TrajectoryRun>& runs, double stiffness) {
    draw_axes(stiffness);
    draw_order(1);
    draw_order(2);
    for (const Relocation relocation : {Relocation::spring, Relocation::return_mapping})
      for (const rig::Integrator integrator :
           {rig::Integrator::semi_implicit, rig::Integrator::half_kick, rig::Integrator::implicit}) {
        std::vector<const TrajectoryRun*> curve;
        for (const TrajectoryRun& run : runs)
          if (run.stiffness == stiffness && run.relocation == relocation && run.integrator == integrator)
            curve.push_back(&run);
        draw_curve(curve);
      }
  }

 private:
  Place place_of(const TrajectoryRun& run) const {
    return {left_ + scales_.x(1e9 * run.seconds), top + scales_.y(shown_error(run.error_m))};
  }

  void draw_curve(const std::vector<const TrajectoryRun*>& curve) {
    if (curve.empty()) return;
    const Hue hue = hue_of(curve.front()->integrator);
    std::vector<Place> places;
    for (const TrajectoryRun* run : curve) places.push_back(place_of(*run));
    chart_.line(places, fmt::format("run c{}", static_cast<int>(hue)));
    const Mark usual = curve.front()->relocation == Relocation::spring ? Mark::disc : Mark::ring;
    for (const TrajectoryRun* run : curve) {
      const bool creeps = run->mark == RunMark::creeping;
      const Mark mark = run->mark == RunMark::none ? usual : creeps ? Mark::diamond : Mark::cross;
      chart_.mark(mark, hue, place_of(*run));
    }
  }

  // A slope: how the error falls where time is inverse to the step.
  void draw_order(int order) {
    const double decades = std::min(std::log10(scales_.last_ns / scales_.first_ns),
                                    std::log10(scales_.most / scales_.least) / order);
    const double ns = scales_.first_ns * std::pow(10, decades);
    const double error = scales_.most * std::pow(10, -order * decades);
    const Place end{left_ + scales_.x(ns), top + scales_.y(error)};
    chart_.line({{left_, top}, end}, "order");
    chart_.text({end.x - 4, end.y - 5}, "end", fmt::format("order {}", order), "small");
  }

  void draw_axes(double stiffness) {
    const double base = top + inner_height;
    for (double ns = scales_.first_ns; ns <= 1.01 * scales_.last_ns; ns *= 10) {
      const double x = left_ + scales_.x(ns);
      chart_.grid({x, top}, {x, base});
      chart_.text({x, base + 16}, "middle", duration_in_words(ns), "small");
    }
    const int first = static_cast<int>(std::lround(std::log10(scales_.least)));
    const int last = static_cast<int>(std::lround(std::log10(scales_.most)));
    for (int power = last; power >= first; power -= std::max(1, (last - first) / 6)) {
      const double y = top + scales_.y(std::pow(10, power));
      chart_.grid({left_, y}, {left_ + inner_width, y});
      chart_.text({left_ - 6, y + 4}, "end", power_of_ten(power), "small");
    }
    chart_.frame(left_, top, inner_width, inner_height);
    chart_.turned_text({left_ - inner_left + 12, top + inner_height / 2}, "error at the end, m");
    chart_.text({left_ + inner_width / 2, base + 34}, "middle", "time of the run", "small");
    chart_.text(
        {left_, top - 8}, "start",
        stiffness == 1 ? "springs as they are" : fmt::format("springs {:g} times as stiff", stiffness),
        "head");
  }

  Chart& chart_;
  const Scales& scales_;
  double left_;
};

void draw_key(Chart& chart) {
  double x = inner_left;
  for (const rig::Integrator integrator :
       {rig::Integrator::semi_implicit, rig::Integrator::half_kick, rig::Integrator::implicit}) {
    chart.mark(Mark::square, hue_of(integrator), {x + 4, 36});
    chart.text({x + 13, 40}, "start", std::string(rig::name_of(integrator)), "small");
    x += 105;
  }
  chart.mark(Mark::disc, Hue::machine, {x + 4, 36});
  chart.text({x + 13, 40}, "start", "spring relocation", "small");
  chart.mark(Mark::ring, Hue::machine, {x + 129, 36});
  chart.text({x + 138, 40}, "start", "return mapping", "small");
  chart.mark(Mark::cross, Hue::machine, {x + 244, 36});
  chart.text({x + 253, 40}, "start", "blew up or halted", "small");
  chart.mark(Mark::diamond, Hue::machine, {x + 364, 36});
  chart.text({x + 373, 40}, "start", "creeps", "small");
}

std::vector<double> stiffnesses_of(const std::vector<TrajectoryRun>& runs) {
  std::vector<double> stiffnesses;
  for (const TrajectoryRun& run : runs)
    if (std::find(stiffnesses.begin(), stiffnesses.end(), run.stiffness) == stiffnesses.end())
      stiffnesses.push_back(run.stiffness);
  return stiffnesses;
}

}  // namespace

std::string trajectory_errors_plot(const std::string& motion, const std::vector<TrajectoryRun>& all) {
  std::vector<TrajectoryRun> runs;
  for (const TrajectoryRun& run : all)
    if (run.motion == motion) runs.push_back(run);
  const std::vector<double> stiffnesses = stiffnesses_of(runs);
  const std::string title = motion + ": error at the end against run time";
  Chart chart(panel_width * static_cast<double>(std::max<std::size_t>(stiffnesses.size(), 1)) + 10, height,
              title, "The numbers stand in trajectories.csv.");
  chart.text({inner_left, 20}, "start", title, "head");
  draw_key(chart);
  const Scales scales(runs);
  double left = 0;
  for (const double stiffness : stiffnesses) {
    Panel(chart, scales, left).draw(runs, stiffness);
    left += panel_width;
  }
  return chart.finished();
}

}  // namespace groundtruth::report
