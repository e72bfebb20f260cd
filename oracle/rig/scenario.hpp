#pragma once
// A machine, a ground, and what happens to them over time.

#include <array>
#include <string>
#include <utility>
#include <vector>

#include <groundtruth/problem/scene.hpp>
#include <groundtruth/rig/motion.hpp>

namespace groundtruth::rig {

// A number over time: straight between the points, constant outside them, and a sine upon it.
struct Signal {
  std::vector<std::pair<double, double>> points;  // (s, value), times ascending; none: 0
  double amplitude = 0;
  double frequency = 0;  // Hz

  double at(double time) const;
  bool is_constant() const { return points.size() < 2 && amplitude == 0; }
};

struct Inputs {
  Signal brake;                            // N
  Signal steering;                         // rad
  std::array<Signal, 3> thrust_in_body;    // N
  std::array<Signal, 3> push_in_world;     // N
  std::array<Signal, 3> gravity_in_world;  // m/s^2

  Controls at(double time) const;
  bool are_constant() const;
};

struct Scenario {
  std::string name;
  std::string description;  // one line
  Machine machine;
  BodyState start;
  std::vector<WheelState> start_wheels;  // none: all are free
  Scene scene;
  Inputs inputs;
  Integrator integrator = Integrator::semi_implicit;
  double h = 1.0 / 240;  // s
  double duration = 10;  // s

  MotionState state_at_start() const;
};

}  // namespace groundtruth::rig
