#pragma once
// Correct rounding: the nearest double, ties to the even one, subnormals included; zero is +0.

#include <optional>

#include <groundtruth/definition/real.hpp>

namespace groundtruth::definition {

// Absent: the magnitude rounds to 2^1024 or more, outside the range of doubles.
std::optional<double> nearest_double(const Rational& exact);
std::optional<double> nearest_double(const Real& exact);

}  // namespace groundtruth::definition
