#pragma once
// Plain double arithmetic for generators. It rounds: what must be exact is made of short dyadics.

#include <cmath>

#include <groundtruth/problem/vector.hpp>

namespace groundtruth::cases {

inline Vector plus(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vector times(double s, const Vector& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline double length(const Vector& a) { return std::sqrt(dot(a, a)); }

inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// from + t (to - from)
inline Vector between(const Vector& from, const Vector& to, double t) {
  return plus(from, times(t, minus(to, from)));
}

}  // namespace groundtruth::cases
