#pragma once
// What the exact engine's functions return.

#include <groundtruth/problem/answer.hpp>

namespace groundtruth::exact {

// The answer, its doubles being the ones nearest to the exact values (ties to even, never -0), and what only
// exact numbers can say.
template <typename AnswerToAsk>
struct Finding {
  AnswerToAsk answer;
  Evidence evidence;
};

// How many significant decimal digits `Evidence::enclosures` has; none: it is empty.
enum class Digits : unsigned { none = 0 };

}  // namespace groundtruth::exact
