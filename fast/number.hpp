#pragma once
// The two number types that fast's algorithms are written for. Not installed.
//
// double answers nearly everything. Where inputs are so large or so small that a product of several of them
// could overflow or underflow, the same algorithm runs on Wide: its exponent holds any product of ten
// doubles.

#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include <Eigen/Core>

#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/vector.hpp>

namespace groundtruth::fast {

using Wide = long double;
static_assert(std::numeric_limits<Wide>::max_exponent >= 16384, "fast needs a number wider than double");

template <class Number>
using Vector3 = Eigen::Matrix<Number, 3, 1>;

template <class Number>
Vector3<Number> as(const Vector& v) {
  return {Number(v[0]), Number(v[1]), Number(v[2])};
}

template <class Number>
Vector rounded(const Vector3<Number>& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

// Magnitudes, both limits included; zero always belongs.
struct Magnitudes {
  double least;
  double greatest;

  bool contains(double x) const {
    const double magnitude = std::abs(x);
    return magnitude <= greatest && (magnitude >= least || magnitude == 0);
  }
  bool contains(const Vector& v) const { return contains(v[0]) && contains(v[1]) && contains(v[2]); }
};

// Names the first component that is not finite ("force[1] leaves the range of doubles"), if there is one.
inline std::optional<Refusal> refuse_unless_finite(const Vector& v, const char* quantity) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!std::isfinite(v[axis]))
      return Refusal{std::string(quantity) + "[" + std::to_string(axis) + "] leaves the range of doubles"};
  return std::nullopt;
}

}  // namespace groundtruth::fast
