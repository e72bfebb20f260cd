#pragma once
// The exact numbers and the kernel on them. Private to this folder: it includes CGAL.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost_mp.h>
#include <boost/multiprecision/gmp.hpp>

#include <groundtruth/problem/vector.hpp>

namespace groundtruth::exact {

using Integer = boost::multiprecision::mpz_int;
using Rational = boost::multiprecision::mpq_rational;
using Kernel = CGAL::Simple_cartesian<Rational>;
using RationalVector = Kernel::Vector_3;

inline int sign(const Rational& value) { return value.sign(); }

// Doubles are rationals: no rounding.
inline RationalVector to_rational(const Vector& vector) {
  return {Rational(vector[0]), Rational(vector[1]), Rational(vector[2])};
}

inline bool is_zero(const RationalVector& vector) {
  return vector.x().is_zero() && vector.y().is_zero() && vector.z().is_zero();
}

}  // namespace groundtruth::exact
