#pragma once
// Which parked machines stand still, and what the others do.

#include <functional>
#include <string_view>
#include <vector>

#include <groundtruth/rig/motion.hpp>
#include <groundtruth/stability/parked.hpp>

namespace groundtruth::stability {

// Judged by the second half of the time.
enum class Fate {
  settled,       // pebbles unmoved to the last bit, the body slower than 1e-5 m/s or getting slower
  swinging,      // pebbles unmoved, the body's motion as large as before
  creeping,      // pebbles move, none leaves the ground
  chattering,    // pebbles leave the ground
  blown_up,      // energy rose by more than 0.1 m g 1 m, at any time
  gave_a_reason  // a step said that it cannot be done
};

std::string_view name_of(Fate fate);

struct Cell {
  Parked parked;
  Fate fate = Fate::settled;
  rig::Halt halt = rig::Halt::none;
  double metres_per_hour = 0;  // of the body, over the second half
  double energy_rise = 0;      // the largest in a step, in parts of m g 1 m
  int most_newton_steps = 0;
};

struct Grid {
  std::vector<double> h_omegas;
  std::vector<double> damping_ratios;
  double slope = 0.05;
  std::uint64_t steps = 4000;  // of each machine
};

// From h omega 0.01 to 10^5: for figures, and coarse for seconds.
Grid fine_grid(double slope);
Grid coarse_grid(double slope);

Cell cell_of(const Parked& parked, std::uint64_t steps);

// Every combination, with one and three wheels, all integrators, both relocations: h omega varies fastest,
// then damping, relocation, wheels, integrator. `progress` is told how many are done.
std::vector<Cell> map_of(const Grid& grid, unsigned jobs,
                         const std::function<void(std::uint64_t done, std::uint64_t all)>& progress);

}  // namespace groundtruth::stability
