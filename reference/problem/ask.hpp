#pragma once
// What can be asked (SPEC sections 3 to 5 and 8). Units are SI; world axes are free; the wheel frame is
// x forward, y right, z down.

#include <optional>
#include <string>
#include <variant>

#include <groundtruth/problem/vector.hpp>

namespace groundtruth {

// Where does x(lambda) = from + lambda (to - from) first enter the solid, for lambda in
// [lambda_first, lambda_last]? Requires lambda_first <= lambda_last; from = to is legal.
struct EntryAsk {
  Vector from{};  // world
  Vector to{};    // world
  double lambda_first = 0;
  double lambda_last = 1;
};

inline constexpr double default_min_uprightness = 0.1;

// Which part of a force can a pebble bear? Requires friction >= 0, brake >= 0, min_uprightness > 0.
struct ClipAsk {
  Vector force_in_wheel{};   // N
  Vector normal_in_wheel{};  // of the surface, outward, any length
  double friction = 0;       // the coefficient mu
  double brake = 0;          // N, half the width of the brake band
  double min_uprightness = default_min_uprightness;
};

// Where a slipping pebble goes (SPEC section 5).
enum class Relocation { spring, return_mapping };

struct Wheel {
  double k_xy = 0;    // N/m, < 0
  double k_z = 0;     // N/m, < 0
  double d_xy = 0;    // N s/m, <= 0
  double d_z = 0;     // N s/m, <= 0
  double z_min = 0;   // m; z_min < z_zero <= z_max
  double z_zero = 0;  // m
  double z_max = 0;   // m
  std::string tyre;
  double min_uprightness = default_min_uprightness;  // > 0
  Relocation relocation = Relocation::spring;
};

struct Frame {
  Vector position_in_world{};
  Quaternion world_from_wheel{1, 0, 0, 0};
  Vector velocity_in_world{};          // of the frame's origin, m/s
  Vector angular_velocity_in_world{};  // rad/s
};

enum class Grip { stick, slip };

struct Free {
  bool operator==(const Free&) const = default;
};

// A pebble on the ground. It is kept in world coordinates: there it can stand still to the last bit.
struct Contact {
  Grip grip = Grip::stick;
  Vector pebble_in_world{};
  Vector pebble_velocity_in_world{};
  Vector normal_in_world{};
  double static_friction = 0;
  double dynamic_friction = 0;
  std::optional<double> maximum_force;  // N; absent: unlimited
  bool operator==(const Contact&) const = default;
};

using WheelState = std::variant<Free, Contact>;

// The next state and force after a step of h > 0 seconds. Requires brake >= 0.
struct StepAsk {
  Wheel wheel;
  Frame frame;
  double brake = 0;  // N
  double h = 0;      // s
  WheelState state;
};

using Ask = std::variant<EntryAsk, ClipAsk, StepAsk>;

}  // namespace groundtruth
