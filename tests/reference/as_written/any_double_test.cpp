// Whatever the doubles and the errata: an answer comes, and every number in it is one.

#include <groundtruth/as_written/clip.hpp>
#include <groundtruth/as_written/entry_point.hpp>
#include <groundtruth/as_written/step.hpp>
#include <groundtruth/as_written/vector_algebra.hpp>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdint>
#include <cstring>
#include <utility>

#include "shapes.hpp"

namespace groundtruth::as_written {
namespace {

double from_bits(std::uint64_t bits) {
  double number = 0;
  std::memcpy(&number, &bits, sizeof number);
  return std::isfinite(number) ? number : 0;
}

// Few values, so that faces meet and forces lie on borders, mixed with all there are.
rc::Gen<double> any_double() {
  return rc::gen::weightedOneOf<double>({{3, rc::gen::element(-2.0, -1.0, 0.0, 1.0, 2.0)},
                                         {1, rc::gen::element(1e-320, -5e-324, 1.7976931348623157e308,
                                                              -1.7976931348623157e308, 9.3e18, 1e-200)},
                                         {1, rc::gen::map(rc::gen::arbitrary<std::uint64_t>(), from_bits)}});
}

rc::Gen<double> above_zero() {
  return rc::gen::map(any_double(), [](double x) { return x == 0 ? 1 : std::fabs(x); });
}

Vector any_vector() { return {*any_double(), *any_double(), *any_double()}; }

Errata any_errata() {
  Errata errata;
  const auto bits = *rc::gen::inRange(0, 1 << number_of_errata);
  for (const Erratum erratum : errata_in_order()) {
    if (((bits >> static_cast<int>(erratum)) & 1) != 0) {
      errata.add(erratum);
    }
  }
  return errata;
}

Shape any_shape(int depth) {
  const int kind = depth == 0 ? 0 : *rc::gen::inRange(0, 4);
  if (kind < 2) {
    return half_space(any_vector(), *any_double());
  }
  std::vector<Shape> operands;
  for (int left = *rc::gen::inRange(0, 5); left > 0; --left) {
    operands.push_back(any_shape(depth - 1));
  }
  return kind == 2 ? union_of(std::move(operands)) : intersection_of(std::move(operands));
}

Scene any_scene() {
  return {{{{"dry", {{"rubber", {0.5, 0.25}}}, std::nullopt}, {"wet", {{"rubber", {1e300, 0}}}, 1e300}},
           covered(0, painted(1, any_shape(2), any_shape(3)))}};
}

RC_GTEST_PROP(AnyDouble, EntryIsWithinTheRange, ()) {
  const Scene scene = any_scene();
  EntryAsk ask{any_vector(), any_vector(), *any_double(), *any_double()};
  if (ask.lambda_first > ask.lambda_last) {
    std::swap(ask.lambda_first, ask.lambda_last);
  }
  const EntryAnswer answer = entry_point(scene, ask, any_errata());
  const auto in_range = [&](double lambda) {
    return ask.lambda_first <= lambda && lambda <= ask.lambda_last;
  };
  if (const Inside* inside = std::get_if<Inside>(&answer)) {
    RC_ASSERT(in_range(inside->lambda));
  }
  if (const Border* border = std::get_if<Border>(&answer)) {
    RC_ASSERT(in_range(border->lambda));
    RC_ASSERT(!is_zero(border->normal_in_world));
  }
}

RC_GTEST_PROP(AnyDouble, ClippedForceIsFinite, ()) {
  const ClipAsk ask{any_vector(), any_vector(), std::fabs(*any_double()), std::fabs(*any_double()),
                    *above_zero()};
  const ClipAnswer answer = clip(ask, any_errata());
  if (const Clipped* clipped = std::get_if<Clipped>(&answer)) {
    RC_ASSERT(is_finite(clipped->force_in_wheel));
  }
}

StepAsk any_step() {
  StepAsk ask;
  ask.wheel = {-*above_zero(),
               -*above_zero(),
               -std::fabs(*any_double()),
               -std::fabs(*any_double()),
               -1,
               0,
               std::fabs(*any_double()),
               "rubber",
               *above_zero(),
               *rc::gen::element(Relocation::spring, Relocation::return_mapping)};
  ask.frame = {
      any_vector(), {*any_double(), *any_double(), *any_double(), *above_zero()}, any_vector(), any_vector()};
  ask.brake = std::fabs(*any_double());
  ask.h = *above_zero();
  if (*rc::gen::inRange(0, 3) != 0) {
    ask.state = Contact{*rc::gen::element(Grip::stick, Grip::slip),
                        any_vector(),
                        any_vector(),
                        any_vector(),
                        std::fabs(*any_double()),
                        std::fabs(*any_double()),
                        std::nullopt};
  }
  return ask;
}

RC_GTEST_PROP(AnyDouble, SteppedStateAndForceAreFinite, ()) {
  const StepAnswer answer = step(any_scene(), any_step(), any_errata());
  if (const Stepped* stepped = std::get_if<Stepped>(&answer)) {
    RC_ASSERT(is_finite(stepped->force_on_frame_in_world));
    if (const Contact* contact = std::get_if<Contact>(&stepped->state)) {
      RC_ASSERT(is_finite(contact->pebble_in_world));
      RC_ASSERT(is_finite(contact->pebble_velocity_in_world));
    }
  }
}

}  // namespace
}  // namespace groundtruth::as_written
