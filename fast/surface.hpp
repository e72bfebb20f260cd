#pragma once
// A surface at the wheel, and what it does to a force (SPEC section 4). Not installed.

#include <groundtruth/fast/number.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::fast {

// Within these, no product that a clip forms in doubles overflows or underflows.
inline constexpr Magnitudes ordinary_clip_size{0x1p-90, 0x1p90};

// What a pebble bears on a surface.
template <class Number>
struct Grasp {
  Vector3<Number> normal_in_wheel;  // any length
  Number friction;
  Number brake;  // N
};

template <class Number>
struct ClippedForce {
  Grip grip;
  Vector3<Number> force_in_wheel;
};

template <class Number>
bool is_upright(const Vector3<Number>& normal_in_wheel, Number min_uprightness) {
  const Number up = -normal_in_wheel.z();
  const Number limit = min_uprightness * min_uprightness;
  return up > 0 && up * up >= limit * normal_in_wheel.template head<2>().squaredNorm();
}

// Requires an upright normal. In Wide any finite doubles and products of two or three of them will do; in
// double the caller need not look at sizes either: what is not ordinary is computed in Wide.
ClippedForce<double> clip_force(const Grasp<double>& grasp, const Vector3<double>& force_in_wheel);
ClippedForce<Wide> clip_force(const Grasp<Wide>& grasp, const Vector3<Wide>& force_in_wheel);

}  // namespace groundtruth::fast
