// SPEC section 4: the clipped force is the Euclidean projection of the force onto the pebble border, shown on
// exact numbers: H is the projection iff it lies in the border and (F' - H).(G - H) <= 0 for every G of the
// border.

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <groundtruth/tests/properties/exact_clip.hpp>
#include <groundtruth/tests/properties/witnesses.hpp>

namespace groundtruth::properties {
namespace {

// 2^-300 of the largest number at hand: what the enclosures of roots leave unsure.
const Rational sliver(exact::Integer(1), exact::Integer(1) << 300);

RC_GTEST_PROP(ClipProjection, TheClippedForceLiesInTheBorderAndKeepsItsNormalPart, ()) {
  const ClipAsk ask = *rc::gen::oneOf(lattice_clips(), border_clips(), wild_clips());
  if (std::holds_alternative<TooSteep>(clip(ask))) return;
  const ExactCase c(ask);
  RC_ASSERT(c.normal_part_is_kept());
  const Tangent h = c.clipped(400);
  const Rational slack = sliver * c.scale_squared();
  RC_ASSERT(h.along_x_squared() <= c.brake_squared() + slack);
  RC_ASSERT(h.squared() <= c.disc_squared() + slack);
}

RC_GTEST_PROP(ClipProjection, NoPointOfTheBorderIsCloser, ()) {
  const ClipAsk ask = *rc::gen::oneOf(lattice_clips(), border_clips(), wild_clips());
  const Rational x(*rc::gen::inRange(-16, 17)), y(*rc::gen::inRange(-16, 17));
  if (std::holds_alternative<TooSteep>(clip(ask))) return;
  const ExactCase c(ask);
  const Tangent h = c.clipped(400), f = c.force();
  const Rational slack = sliver * c.scale_squared();
  // Points all over the border and beyond, drawn back into it; and those that matter most, near H and near
  // F'.
  for (const Tangent& aim :
       {c.tangent(x, y), c.tangent(x * c.brake(), y * c.brake()), f, h, h + c.tangent(x, y)}) {
    const Tangent g = c.drawn_into_border(aim);
    RC_ASSERT(dot(f - h, g - h) <= slack);
  }
}

// With the same normal part the border is the same.
RC_GTEST_PROP(ClipProjection, ForcesNeverMoveApart, ()) {
  const ClipAsk ask = *rc::gen::oneOf(lattice_clips(), border_clips(), wild_clips());
  const Rational x(*rc::gen::inRange(-8, 9), 2), y(*rc::gen::inRange(-8, 9), 2);
  if (std::holds_alternative<TooSteep>(clip(ask))) return;
  const ExactCase c(ask);
  const ExactCase other = c.pushed(x, y);
  const Tangent apart = c.clipped(400) - other.clipped(400);
  const Tangent before = c.force() - other.force();
  RC_ASSERT(apart.squared() <= before.squared() + sliver * (c.scale_squared() + other.scale_squared()));
}

RC_GTEST_PROP(ClipProjection, TheOppositeTangentialForceIsClippedToTheOpposite, ()) {
  const ClipAsk ask = *rc::gen::oneOf(lattice_clips(), border_clips(), wild_clips());
  if (std::holds_alternative<TooSteep>(clip(ask))) return;
  const ExactCase c(ask);
  RC_ASSERT(c.clips_opposite_to(c.with_opposite_tangential_part()));
}

// A larger border holds a point at least as close, and whatever the smaller one held.
RC_GTEST_PROP(ClipProjection, MoreFrictionOrMoreBrakeClipsLess, ()) {
  const ClipAsk ask = *rc::gen::oneOf(lattice_clips(), border_clips());
  ClipAsk more = ask;
  more.friction += *rc::gen::inRange(0, 5) / 4.0;
  more.brake += *rc::gen::inRange(0, 9);
  const ClipAnswer answer = clip(ask);
  const ClipAnswer answer_to_more = clip(more);
  if (std::holds_alternative<TooSteep>(answer)) return;
  if (std::get<Clipped>(answer).grip == Grip::stick) RC_ASSERT(answer_to_more == answer);
  const ExactCase c(ask), larger(more);
  const Rational slack = sliver * c.scale_squared();
  const Tangent f = c.force();
  RC_ASSERT((f - larger.clipped(400)).squared() <= (f - c.clipped(400)).squared() + slack);
}

// Where the clipped force is one of doubles, it is a force that can be clipped again.
RC_GTEST_PROP(ClipProjection, ClippingTwiceIsClippingOnce, ()) {
  const ClipAsk ask = *rc::gen::oneOf(lattice_clips(), border_clips());
  const ClipAnswer answer = clip(ask);
  const auto* clipped = std::get_if<Clipped>(&answer);
  if (!clipped) return;
  const auto exact_force = ExactCase(ask).force_in_wheel();
  for (std::size_t i = 0; i < 3; ++i)
    if (sign(exact_force[i] - exact::RootSum(Rational(clipped->force_in_wheel[i]))) != 0) return;
  RC_CLASSIFY(clipped->grip == Grip::slip, "clipped");
  ClipAsk again = ask;
  again.force_in_wheel = clipped->force_in_wheel;
  RC_ASSERT(clip(again) == ClipAnswer(Clipped{Grip::stick, clipped->force_in_wheel}));
}

RC_GTEST_PROP(ClipProjection, TheDoublesAreTheNearestToTheExactForce, ()) {
  const ClipAsk ask = *rc::gen::oneOf(lattice_clips(), border_clips(), wild_clips());
  const ClipAnswer answer = clip(ask);
  const auto* clipped = std::get_if<Clipped>(&answer);
  if (!clipped) return;
  const auto exact_force = ExactCase(ask).force_in_wheel();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const double value = clipped->force_in_wheel[i];
    const double below = std::nextafter(value, -infinity), above = std::nextafter(value, infinity);
    if (std::isinf(below) || std::isinf(above)) continue;
    const Rational middle_below = (Rational(below) + Rational(value)) / 2;
    const Rational middle_above = (Rational(above) + Rational(value)) / 2;
    RC_ASSERT(sign(exact_force[i] - exact::RootSum(middle_below)) >= 0);
    RC_ASSERT(sign(exact_force[i] - exact::RootSum(middle_above)) <= 0);
  }
}

}  // namespace
}  // namespace groundtruth::properties
