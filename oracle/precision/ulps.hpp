#pragma once
// How far doubles are from exact numbers that were never rounded.

#include <string>

#include <groundtruth/problem/answer.hpp>

namespace groundtruth::precision {

// |got - exact| in units of the last place of the exact number's binade (2^-1074 at 0 and below the normal
// doubles); the largest double where it is larger still, or `got` is not finite. A correctly rounded number
// is at most 0.5 off. `exact` is a fraction ("1/3", "-2") or a decimal ("1.5", "-2.5e-3").
double error_in_ulps(double got, const std::string& exact);

// Of the numbers of an answer: lambda, or every vector of force, pebble and velocity, whose components are
// all measured in ulps of the exact vector's largest one; the worst counts. Requires that both are of one
// kind. `evidence` bears the exact numbers: lambda_exact, or enclosures of many digits; a vector that it does
// not enclose is exact as it stands in `exact`.
double error_in_ulps(const Answer& got, const Answer& exact, const Evidence& evidence);

}  // namespace groundtruth::precision
