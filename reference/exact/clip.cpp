#include <groundtruth/exact/clip.hpp>

#include <groundtruth/exact/arithmetic/answer_numbers.hpp>
#include <groundtruth/exact/wheel/clipping.hpp>

namespace groundtruth::exact {

Finding<ClipAnswer> clip(const ClipAsk& ask, Digits digits) {
  const RationalVector normal_in_wheel = to_rational(ask.normal_in_wheel);
  if (!is_upright(normal_in_wheel, Rational(ask.min_uprightness))) return {TooSteep{}, {}};
  const ExactClip clipped = clip_force(to_rational(ask.force_in_wheel), normal_in_wheel,
                                       {Rational(ask.friction), Rational(ask.brake)});
  AnswerNumbers numbers(digits);
  const Vector force_in_wheel = numbers.round("force", clipped.force_in_wheel.components());
  if (numbers.refusal()) return {*numbers.refusal(), {}};
  return {Clipped{clipped.grip, force_in_wheel}, std::move(numbers).evidence()};
}

}  // namespace groundtruth::exact
