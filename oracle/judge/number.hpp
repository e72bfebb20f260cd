#pragma once
// The exact numbers that answers are weighed with. Private to this folder.

#include <array>
#include <string>

#include <boost/multiprecision/cpp_int.hpp>

#include <groundtruth/problem/vector.hpp>

namespace groundtruth::judge {

using Integer =
    boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;
using Rational =
    boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;
using RationalVector = std::array<Rational, 3>;

inline Rational rational(double value) { return Rational(value); }
inline RationalVector rational(const Vector& v) { return {Rational(v[0]), Rational(v[1]), Rational(v[2])}; }

// "3/7", "-2", as Evidence::lambda_exact has it.
Rational read_fraction(const std::string& text);

// The distance of neighbouring doubles in the binade of `value`, 2^-1074 at 0 and below the normal doubles.
Rational unit_in_last_place(const Rational& value);

inline Rational dot(const RationalVector& a, const RationalVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline RationalVector minus(const RationalVector& a, const RationalVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
// a + t b
inline RationalVector along(const RationalVector& a, const Rational& t, const RationalVector& b) {
  return {a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]};
}

}  // namespace groundtruth::judge
