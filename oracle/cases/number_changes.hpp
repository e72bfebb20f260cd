#pragma once
// Changes to one number. Private to this folder.

#include <cmath>

#include <groundtruth/cases/random.hpp>

namespace groundtruth::cases {

// One of a neighbouring double, another sign or scale, zero, a round number near it. Finite.
double changed_number(double value, Random& random);

// The same for one that must stay >= 0, or > 0.
inline double changed_size(double value, Random& random) { return std::abs(changed_number(value, random)); }
inline double changed_positive(double value, Random& random) {
  const double size = changed_size(value, random);
  return size > 0 ? size : value;
}

// One or all coordinates changed, or one replaced by another.
Vector changed_vector(const Vector& value, Random& random);

}  // namespace groundtruth::cases
