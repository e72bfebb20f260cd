#pragma once
// The exact numbers that explanations are made of, and how they are read by people.

#include <array>
#include <string>

#include <boost/multiprecision/gmp.hpp>

#include <groundtruth/problem/vector.hpp>

namespace groundtruth::explanation {

using Rational =
    boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;
using RationalVector = std::array<Rational, 3>;

inline RationalVector rational(const Vector& v) { return {Rational(v[0]), Rational(v[1]), Rational(v[2])}; }

inline Rational dot(const RationalVector& a, const RationalVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
// a + t b
inline RationalVector along(const RationalVector& a, const Rational& t, const RationalVector& b) {
  return {a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]};
}
inline RationalVector minus(const RationalVector& a, const RationalVector& b) { return along(a, -1, b); }
RationalVector cross(const RationalVector& a, const RationalVector& b);

// "3/7", "-2". Long ones are cut: "123456.../987654... (80 and 92 digits)".
std::string write_fraction(const Rational& value);

// To 20 digits or the exact value if it is no longer.
std::string write_approximately(const Rational& value);
// Of the root, for value >= 0.
std::string write_root(const Rational& value);

// A double near the value, for pictures; not necessarily the nearest one.
double nearby(const Rational& value);
double nearby_root(const Rational& value);

}  // namespace groundtruth::explanation
