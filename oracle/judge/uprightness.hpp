#pragma once
// The threshold of "too steep", moved by a tolerance. Private to this folder.

#include <algorithm>
#include <limits>

#include <groundtruth/judge/verdict.hpp>

namespace groundtruth::judge {

// |n_z| >= t r is within rho of its scale |n_z| + t r, where r^2 = n_x^2 + n_y^2, iff
// |n_z| >= t (1 - rho) / (1 + rho) r; and the other way about. Requires rho < 1.
inline double more_lenient(double min_uprightness, const Tolerance& tolerance) {
  const double rho = tolerance.relative_decision;
  return std::max(min_uprightness * ((1 - rho) / (1 + rho)), std::numeric_limits<double>::denorm_min());
}
inline double stricter(double min_uprightness, const Tolerance& tolerance) {
  const double rho = tolerance.relative_decision;
  return std::min(min_uprightness * ((1 + rho) / (1 - rho)), std::numeric_limits<double>::max());
}

}  // namespace groundtruth::judge
