#pragma once
// How an answer differs from the exact one, without any tolerance.

#include <array>
#include <cstddef>
#include <string_view>

#include <groundtruth/problem/answer.hpp>

namespace groundtruth::judge {

// The first of these in which two answers differ; later ones then mean nothing.
enum class Difference {
  none,
  refusal,     // one of them refuses, or they refuse for different reasons
  hit_miss,    // miss against hit
  face,        // inside against border, leaf, or normal
  material,    // or friction and maximum force of the contact
  stick_slip,  // stick, slip, too steep
  state,       // outcome of a step, or kind of its state
  lambda,      // not the same double
  numbers      // force, pebble or velocity not the same doubles
};

inline constexpr std::size_t number_of_differences = 9;

std::string_view name_of(Difference difference);

struct Comparison {
  Difference difference = Difference::none;
  // |got - exact| in units of the last place of the exact double (2^-1074 at 0); for vectors, of its largest
  // component; of each vector the worst; the largest double where it is larger still. 0 unless both answers
  // have the same numbers to compare.
  double lambda_ulps = 0;
  double vector_ulps = 0;
};

struct AnswerWithEvidence {
  const Answer& answer;
  const Evidence& evidence;
};

// Both answer the same ask; `exact` bears correctly rounded doubles. Evidence that `got` lacks is not held
// against it; other evidence than the exact one's is a difference in lambda, or in the face.
Comparison compare(const AnswerWithEvidence& got, const AnswerWithEvidence& exact);

}  // namespace groundtruth::judge
