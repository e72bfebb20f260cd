#pragma once
// Exact numbers as doubles and decimals. Private to this folder.

#include <optional>
#include <string>

#include <groundtruth/exact/arithmetic/root_sum.hpp>
#include <groundtruth/problem/answer.hpp>

namespace groundtruth::exact {

// The double nearest to the value, ties to even, subnormals included; infinity where IEEE 754 rounds to it.
// Never -0. Proof: proofs-notes/rounding-of-exact-results.md, section 1 for rationals, 2 for sums of roots.
double nearest_double(const Rational& value);
double nearest_double(const RootSum& value);

// The two decimals of this many significant digits next to the value, or twice the value if it is one.
// Requires digits > 0.
Enclosure decimal_enclosure(std::string quantity, const RootSum& value, unsigned digits);

}  // namespace groundtruth::exact
