#pragma once
// A clip with numbers that need not be doubles, as a step has them. Private to this folder.

#include <groundtruth/explanation/explanation.hpp>

namespace groundtruth::explanation {

struct ClipNumbers {
  RationalVector force_in_wheel;
  RationalVector normal_in_wheel;
  Rational friction;
  Rational brake;
  Rational min_uprightness;
};

ClipFacts clip_facts(const ClipNumbers& numbers);

bool is_upright(const RationalVector& normal_in_wheel, const Rational& min_uprightness);

}  // namespace groundtruth::explanation
