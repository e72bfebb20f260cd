#pragma once
// A run as a figure: height, speed, energy, and for each wheel load, friction and state over time.

#include <optional>
#include <string>
#include <vector>

#include <groundtruth/report/plot.hpp>
#include <groundtruth/rig/simulation.hpp>

namespace groundtruth::report {

// Least and greatest of a quantity, column by column of the plot: long runs are no longer than short ones.
class Envelope {
 public:
  explicit Envelope(std::size_t columns) : columns_(columns) {}
  void add(std::size_t column, double value);
  std::vector<std::pair<double, double>> points(double x_per_column) const;

 private:
  struct Extent {
    double least = 0;
    double greatest = 0;
    bool is_set = false;
  };
  std::vector<Extent> columns_;
};

// Made for one run of the scenario; shown every moment of it.
class TrajectoryPlot {
 public:
  explicit TrajectoryPlot(const rig::Scenario& scenario);
  void add(const rig::Moment& moment);
  std::string svg() const;

 private:
  enum class Seen { nothing, stick, slip };
  struct WheelPlot {
    Envelope load;
    Envelope friction;
    std::optional<Eigen::Vector3d> normal_in_world;  // of the contact that the next force comes from
    std::vector<Seen> seen;
  };

  void add(const WheelState& state, const Eigen::Vector3d& force, std::size_t column, WheelPlot& plot) const;
  std::vector<Band> bands_of(const WheelPlot& plot) const;

  std::string title_;
  Eigen::Vector3d up_in_world_;  // against gravity at the start
  double h_;
  double duration_;
  std::size_t columns_;  // one a step, if there are few steps
  Envelope height_;
  Envelope speed_;
  Envelope energy_;
  std::vector<WheelPlot> wheels_;
};

}  // namespace groundtruth::report
