#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <groundtruth/definition/clip.hpp>

namespace groundtruth::definition {
namespace {

using Float = boost::multiprecision::cpp_bin_float_100;
using Floats = std::array<Float, 3>;

double some_double(int exponents) {
  const double mantissa = *rc::gen::inRange(-4096, 4097);
  return std::ldexp(mantissa * (1 + *rc::gen::inRange(0, 1000) * 0x1p-40),
                    *rc::gen::inRange(-exponents, 1) - 10);
}

ClipAsk some_ask() {
  ClipAsk ask;
  ask.force_in_wheel = {some_double(4), some_double(4), some_double(4)};
  ask.normal_in_wheel = {some_double(4), some_double(4), -std::fabs(some_double(2))};
  ask.friction = std::fabs(some_double(4));
  ask.brake = std::fabs(some_double(4));
  return ask;
}

// The three cases of SPEC section 4, as they stand there, in 100 digits.
Floats by_cases(const ClipAsk& ask) {
  const Floats F{ask.force_in_wheel[0], ask.force_in_wheel[1], ask.force_in_wheel[2]};
  const Floats n{ask.normal_in_wheel[0], ask.normal_in_wheel[1], ask.normal_in_wheel[2]};
  const Float r = sqrt(n[0] * n[0] + n[2] * n[2]), length = sqrt(r * r + n[1] * n[1]);
  const Floats X{-n[2] / r, 0, n[0] / r};
  const Floats Y{-n[0] * n[1] / (r * length), r / length, -n[1] * n[2] / (r * length)};
  const Floats Z{-n[0] / length, -n[1] / length, -n[2] / length};
  const auto dot = [](const Floats& a, const Floats& b) -> Float {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  const Float x = dot(X, F), y = dot(Y, F), z = dot(Z, F), reach = ask.friction * abs(z), B = ask.brake;
  if (abs(x) <= B && x * x + y * y <= reach * reach) return F;
  Float h_x = reach * x / sqrt(x * x + y * y), h_y = reach * y / sqrt(x * x + y * y);
  if (B < reach) {
    const Float s = sqrt(reach * reach - B * B);
    const Float side_x = x < 0 ? -1 : 1, side_y = y < 0 ? -1 : 1;
    if (abs(y) <= s) h_x = side_x * B, h_y = y;
    if (abs(y) > s && B * abs(y) <= abs(x) * s) h_x = side_x * B, h_y = side_y * s;
  }
  Floats result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = h_x * X[i] + h_y * Y[i] + z * Z[i];
  return result;
}

RC_GTEST_PROP(ClipLaw, ForceIsWithinHalfAnUlpOfTheCases, ()) {
  const ClipAsk ask = some_ask();
  const ClipAnswer answer = clip(ask);
  RC_PRE(std::holds_alternative<Clipped>(answer));
  const Vector& got = std::get<Clipped>(answer).force_in_wheel;
  const Floats expected = by_cases(ask);
  // What 100 digits leave where terms of this size cancel.
  const Vector& force = ask.force_in_wheel;
  const Float noise = Float("1e-90") * (std::fabs(force[0]) + std::fabs(force[1]) + std::fabs(force[2]));
  for (std::size_t i = 0; i < 3; ++i) {
    const double size = std::fabs(got[i]);
    const Float half_ulp = (Float(std::nextafter(size, INFINITY)) - Float(size)) / 2;
    RC_ASSERT(abs(Float(got[i]) - expected[i]) <= half_ulp * (1 + Float("1e-60")) + noise);
  }
}

RC_GTEST_PROP(ClipLaw, MirroringTheWheelMirrorsTheForce, ()) {
  const ClipAsk ask = some_ask();
  ClipAsk mirrored = ask;
  mirrored.force_in_wheel[1] = -ask.force_in_wheel[1];
  mirrored.normal_in_wheel[1] = -ask.normal_in_wheel[1];
  const ClipAnswer answer = clip(ask);
  RC_PRE(std::holds_alternative<Clipped>(answer));
  Clipped expected = std::get<Clipped>(answer);
  expected.force_in_wheel[1] = -expected.force_in_wheel[1];
  RC_ASSERT(clip(mirrored) == ClipAnswer(expected));
}

RC_GTEST_PROP(ClipLaw, OnLevelGroundHoldsTheBorder, ()) {
  ClipAsk ask = some_ask();
  ask.normal_in_wheel = {0, 0, -1};
  const Clipped got = std::get<Clipped>(clip(ask));
  const auto& [x, y, z] = got.force_in_wheel;
  RC_ASSERT(z == ask.force_in_wheel[2]);
  RC_ASSERT(std::fabs(x) <= ask.brake);
  RC_ASSERT(std::hypot(x, y) <= ask.friction * std::fabs(z) * (1 + 4e-16) + 0x1p-1070);
  RC_ASSERT(got.grip == Grip::slip || got.force_in_wheel == ask.force_in_wheel);
}

}  // namespace
}  // namespace groundtruth::definition
