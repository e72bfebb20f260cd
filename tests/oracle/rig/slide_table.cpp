#include <fmt/core.h>

#include <groundtruth/tests/oracle/rig/closed_forms.hpp>
#include <groundtruth/tests/oracle/rig/motion_tables.hpp>

namespace groundtruth::rig {
namespace {

constexpr Integrator integrators[] = {Integrator::semi_implicit, Integrator::half_kick, Integrator::implicit};

void print_slides(const char* name, Body body) {
  for (const Integrator integrator : integrators) {
    fmt::print("{:<30}{:<14}", name, name_of(integrator));
    for (const int steps_a_second : {240, 480, 960, 1920})
      fmt::print("{:>12.2g}", slide_error(body, integrator, 1.0 / steps_a_second));
    fmt::print("\n");
    std::fflush(stdout);
  }
}

void print_stops() {
  double last[] = {0, 0, 0};
  for (int halvings = 0; halvings < 6; ++halvings) {
    fmt::print("{:>12.6g}", stop_step(halvings));
    for (std::size_t i = 0; i < 3; ++i) {
      const double error = stop_error(integrators[i], halvings);
      fmt::print("{:>18.6g}{:>8}", error, halvings == 0 ? "" : fmt::format("{:.3f}", last[i] / error));
      last[i] = error;
    }
    fmt::print("\n");
    std::fflush(stdout);
  }
}

}  // namespace

void print_slide_and_stop_table() {
  fmt::print("Acceleration of a slide against g (sin a - mu cos a): relative error\n{:<44}", "");
  for (const char* h : {"h = 1/240", "1/480", "1/960", "1/1920"}) fmt::print("{:>12}", h);
  fmt::print("\n");
  print_slides("one wheel", Body::one_wheel);
  print_slides("three, on a body that is held", Body::three_wheels_that_cannot_turn);
  print_slides("three, on one that may pitch", Body::three_wheels);
  fmt::print("\nPath to rest against v^2 / (2 mu g), m, and how much less than with twice the step\n{:>12}",
             "h, s");
  for (const Integrator integrator : integrators) fmt::print("{:>18}{:>8}", name_of(integrator), "");
  fmt::print("\n");
  print_stops();
  fmt::print("\n");
}

}  // namespace groundtruth::rig
