#include <groundtruth/report/trajectory_plot.hpp>

#include <algorithm>

#include <fmt/format.h>

#include <groundtruth/rig/body.hpp>

namespace groundtruth::report {
namespace {

std::size_t columns_of(const rig::Scenario& scenario) {
  return static_cast<std::size_t>(std::clamp(scenario.duration / scenario.h, 1.0, double{plot_width}));
}

}  // namespace

void Envelope::add(std::size_t column, double value) {
  Extent& extent = columns_[column];
  extent.least = extent.is_set ? std::min(extent.least, value) : value;
  extent.greatest = extent.is_set ? std::max(extent.greatest, value) : value;
  extent.is_set = true;
}

std::vector<std::pair<double, double>> Envelope::points(double x_per_column) const {
  std::vector<std::pair<double, double>> points;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (!columns_[i].is_set) continue;
    const double x = (static_cast<double>(i) + 0.5) * x_per_column;
    points.emplace_back(x, columns_[i].least);
    if (columns_[i].greatest > columns_[i].least) points.emplace_back(x, columns_[i].greatest);
  }
  return points;
}

TrajectoryPlot::TrajectoryPlot(const rig::Scenario& scenario)
    : title_(scenario.name + ": " + scenario.description),
      up_in_world_(-scenario.inputs.at(0).gravity_in_world.normalized()),
      h_(scenario.h),
      duration_(std::max(scenario.duration, scenario.h)),
      columns_(columns_of(scenario)),
      height_(columns_),
      speed_(columns_),
      energy_(columns_),
      wheels_(scenario.machine.wheels.size(),
              {Envelope(columns_), Envelope(columns_), {}, std::vector<Seen>(columns_, Seen::nothing)}) {}

void TrajectoryPlot::add(const rig::Moment& moment) {
  const double part = std::clamp((moment.time - h_ / 2) / duration_, 0.0, 1.0);
  const auto column = std::min(static_cast<std::size_t>(part * static_cast<double>(columns_)), columns_ - 1);
  const rig::BodyState& body = moment.state.body;
  height_.add(column, body.position_in_world.dot(up_in_world_));
  speed_.add(column, body.velocity_in_world.norm());
  energy_.add(column, moment.energy / 1000);
  for (std::size_t i = 0; i < wheels_.size(); ++i)
    add(moment.state.wheels[i], moment.record.forces_in_world[i], column, wheels_[i]);
}

void TrajectoryPlot::add(const WheelState& state, const Eigen::Vector3d& force, std::size_t column,
                         WheelPlot& plot) const {
  const Eigen::Vector3d normal = plot.normal_in_world.value_or(Eigen::Vector3d::Zero());
  const double load = force.dot(normal);
  plot.load.add(column, load / 1000);
  plot.friction.add(column, (force - load * normal).norm() / 1000);
  plot.normal_in_world.reset();
  const auto* contact = std::get_if<Contact>(&state);
  if (contact == nullptr) return;
  plot.normal_in_world = rig::vector_of(contact->normal_in_world).normalized();
  const Seen seen = contact->grip == Grip::stick ? Seen::stick : Seen::slip;
  plot.seen[column] = std::max(plot.seen[column], seen);
}

std::vector<Band> TrajectoryPlot::bands_of(const WheelPlot& plot) const {
  const double per_column = duration_ / static_cast<double>(columns_);
  std::vector<Band> bands;
  Seen last = Seen::nothing;
  for (std::size_t i = 0; i < plot.seen.size(); ++i) {
    const double from = static_cast<double>(i) * per_column;
    if (plot.seen[i] != Seen::nothing) {
      if (plot.seen[i] != last)
        bands.push_back({from, from, plot.seen[i] == Seen::stick ? Wash::first : Wash::second});
      bands.back().to = from + per_column;
    }
    last = plot.seen[i];
  }
  return bands;
}

std::string TrajectoryPlot::svg() const {
  const double per_column = duration_ / static_cast<double>(columns_);
  Figure figure{title_, "time, s", 0, duration_, {{Wash::first, "stick"}, {Wash::second, "slip"}}, {}};
  figure.panels.push_back(
      {"height of the centre of mass, m", {{"", Ink::first, height_.points(per_column)}}, {}});
  figure.panels.push_back({"speed, m/s", {{"", Ink::first, speed_.points(per_column)}}, {}});
  figure.panels.push_back({"energy, kJ", {{"", Ink::first, energy_.points(per_column)}}, {}});
  for (std::size_t i = 0; i < wheels_.size(); ++i) {
    figure.panels.push_back({fmt::format("wheel {}, kN", i),
                             {{"load", Ink::first, wheels_[i].load.points(per_column)},
                              {"friction", Ink::second, wheels_[i].friction.points(per_column)}},
                             bands_of(wheels_[i])});
  }
  return svg_of(figure);
}

}  // namespace groundtruth::report
