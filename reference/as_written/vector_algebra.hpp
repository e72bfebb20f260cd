#pragma once
// Vectors in plain doubles, with + - * / sqrt and powers of two only, so that every machine gets the same
// bits.

#include <algorithm>
#include <cmath>

#include <groundtruth/problem/vector.hpp>

namespace groundtruth::as_written {

inline double dot(const Vector& a, const Vector& b) { return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]; }

inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Vector plus(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vector times(double s, const Vector& a) { return {s * a[0], s * a[1], s * a[2]}; }

inline bool is_zero(const Vector& a) { return a == Vector{0, 0, 0}; }

inline bool is_finite(const Vector& a) {
  return std::isfinite(a[0]) && std::isfinite(a[1]) && std::isfinite(a[2]);
}

// The exponent e for which the largest |number| times 2^-e lies in [1, 2). 0 if all are zero.
template <typename Numbers>
int exponent_of(const Numbers& numbers) {
  double largest = 0;
  for (const double number : numbers) {
    largest = std::max(largest, std::fabs(number));
  }
  return largest == 0 ? 0 : std::ilogb(largest);
}

// Times 2^exponent; exact unless the result underflows or overflows.
template <typename Numbers>
Numbers scaled(Numbers numbers, int exponent) {
  for (double& number : numbers) {
    number = std::scalbn(number, exponent);
  }
  return numbers;
}

// The same direction, its largest component in [1, 2), so that products of two can neither overflow nor
// vanish together.
template <typename Numbers>
Numbers scaled_near_one(const Numbers& numbers) {
  return scaled(numbers, -exponent_of(numbers));
}

// sqrt(a^2 + b^2) without undue overflow or underflow.
inline double length(double a, double b) {
  const int exponent = exponent_of(std::array<double, 2>{a, b});
  const double p = std::scalbn(a, -exponent);
  const double q = std::scalbn(b, -exponent);
  return std::scalbn(std::sqrt(p * p + q * q), exponent);
}

// Three orthonormal axes of one frame, seen from another: the columns of a rotation.
struct Axes {
  Vector x{};
  Vector y{};
  Vector z{};
};

// From the outer frame into the one that the axes span.
inline Vector into(const Axes& axes, const Vector& v) {
  return {dot(axes.x, v), dot(axes.y, v), dot(axes.z, v)};
}

// From the frame that the axes span to the outer one.
inline Vector out_of(const Axes& axes, const Vector& v) {
  return plus(plus(times(v[0], axes.x), times(v[1], axes.y)), times(v[2], axes.z));
}

}  // namespace groundtruth::as_written
