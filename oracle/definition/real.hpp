#pragma once
// The two towers in use: Real, a field, to derive numbers in; Whole, a ring, to decide signs in quickly.

#include <groundtruth/definition/surd.hpp>

namespace groundtruth::definition {

using Real = Surd<Rational>;
using Whole = Surd<Integer>;

// The square root of a number >= 0 that is plain (as every number under a root of SPEC sections 4 and 5 is).
// The root of a rational square is plain. Throws std::logic_error if the number is not plain.
Real square_root(const Real& square);

Triple<Real> real(const Triple<Rational>& vector);

// Points x with x = numerators / weight, weight > 0.
struct CommonWeight {
  Triple<Whole> first, second;
  Integer weight;
};
CommonWeight over_common_weight(const Triple<Real>& first, const Triple<Real>& second);

// number / weight. Requires weight > 0.
Real quotient(const Whole& number, const Integer& weight);

}  // namespace groundtruth::definition
