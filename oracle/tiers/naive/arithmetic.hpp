#pragma once
// What the naive algorithms ask of a number type besides + - * / and comparisons.

#include <cmath>

namespace groundtruth::tiers::naive {

// Specialised beside each number type.
template <class Real>
struct Arithmetic {
  static constexpr bool has_roots = true;
  static Real root(const Real& value) {
    using std::sqrt;
    return sqrt(value);
  }
  static double nearest_double(const Real& value) { return static_cast<double>(value); }
};

// -1, 0 or 1; of a NaN: 0.
template <class Real>
int sign_of(const Real& value) {
  static const Real zero(0);
  if (value > zero) return 1;
  return value < zero ? -1 : 0;
}

// -0 becomes 0: answers bear no negative zeros.
template <class Real>
double as_double(const Real& value) {
  return Arithmetic<Real>::nearest_double(value) + 0.0;
}

}  // namespace groundtruth::tiers::naive
