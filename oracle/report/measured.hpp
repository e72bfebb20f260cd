#pragma once
// All that `groundtruth report` measures: what its page, tables and files are made from.

#include <cstdint>
#include <string>
#include <vector>

#include <groundtruth/precision/left_out.hpp>
#include <groundtruth/precision/machine.hpp>
#include <groundtruth/precision/measurement.hpp>
#include <groundtruth/precision/trajectories.hpp>
#include <groundtruth/stability/map.hpp>

namespace groundtruth::report {

// Every tier on one population of a scene's asks.
struct Study {
  std::string scene;
  tiers::AskKind kind = tiers::AskKind::entry;
  precision::Population population = precision::Population::ordinary;
  std::size_t leaves = 0;
  std::size_t asks = 0;
  std::vector<precision::TierResult> results;
};

// Something that was not run, or failed, and why.
struct Omission {
  std::string what;
  std::string why;
};

struct Measured {
  precision::Machine machine;
  std::string extent;  // "quick" or "full"
  std::uint64_t seed = 1;
  double seconds = 0;  // that measuring took
  std::vector<Study> studies;
  std::vector<precision::LeftOutWorth> left_out;
  std::vector<precision::TrajectoryRun> trajectories;
  stability::Grid grid;
  std::vector<stability::Cell> cells;
  std::vector<Omission> omissions;
};

}  // namespace groundtruth::report
