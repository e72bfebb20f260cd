#pragma once
// Wheels in exact numbers, for the tests of step asks: z is measured in the wheel frame, with the rational
// rotation of section 1.

#include <cstdint>
#include <variant>

#include <gtest/gtest.h>

#include <groundtruth/cases/landmarks.hpp>
#include <groundtruth/cases/random.hpp>
#include <groundtruth/problem/ask.hpp>

#include "exact_checks.hpp"

namespace groundtruth::cases::testing {

inline constexpr int tries = 200;

template <class Check>
void for_many(StepAsk (*make)(const Landmarks&, Random&), const Scene& scene, Check check) {
  const Landmarks landmarks = survey(scene);
  for (std::uint64_t i = 0; i < tries; ++i) {
    Random random(i);
    SCOPED_TRACE(i);
    check(make(landmarks, random));
  }
}

inline RationalVector in_wheel(const StepAsk& ask, const RationalVector& direction_in_world) {
  return rotated(inverse(ask.frame.world_from_wheel), direction_in_world);
}

inline const Contact& contact_of(const StepAsk& ask) { return std::get<Contact>(ask.state); }

inline RationalVector pebble_in_wheel(const StepAsk& ask) {
  return in_wheel(ask, minus(exactly(contact_of(ask).pebble_in_world), exactly(ask.frame.position_in_world)));
}

inline RationalVector normal_in_wheel(const StepAsk& ask) {
  return in_wheel(ask, exactly(contact_of(ask).normal_in_world));
}

// The force law of section 5.
inline RationalVector force_in_wheel(const StepAsk& ask) {
  const RationalVector pebble = pebble_in_wheel(ask);
  const RationalVector arm =
      minus(exactly(contact_of(ask).pebble_in_world), exactly(ask.frame.position_in_world));
  const RationalVector turning = cross(exactly(ask.frame.angular_velocity_in_world), arm);
  const RationalVector velocity = in_wheel(ask, minus(minus(exactly(contact_of(ask).pebble_velocity_in_world),
                                                            exactly(ask.frame.velocity_in_world)),
                                                      turning));
  const Wheel& w = ask.wheel;
  return {Rational(w.k_xy) * pebble[0] + Rational(w.d_xy) * velocity[0],
          Rational(w.k_xy) * pebble[1] + Rational(w.d_xy) * velocity[1],
          Rational(w.k_z) * (pebble[2] - Rational(w.z_zero)) + Rational(w.d_z) * velocity[2]};
}

// F'_z |n|, which has the sign of F'_z.
inline Rational pressure(const StepAsk& ask) { return -dot(force_in_wheel(ask), normal_in_wheel(ask)); }

// -1, 0, 1: inside, on, outside the disc of the friction that counts.
inline int side_of_disc(const StepAsk& ask) {
  const RationalVector f = force_in_wheel(ask);
  const RationalVector n = normal_in_wheel(ask);
  const Rational n_squared = dot(n, n);
  const Rational down = dot(f, n);
  const Contact& contact = contact_of(ask);
  const Rational mu(contact.grip == Grip::stick ? contact.static_friction : contact.dynamic_friction);
  const Rational across = dot(f, f) - down * down / n_squared;
  const Rational most = mu * mu * down * down / n_squared;
  return across < most ? -1 : across == most ? 0 : 1;
}

// A point on the axis of the strut, in the world.
inline RationalVector on_strut(const StepAsk& ask, double z) {
  const RationalVector arm =
      rotated(ask.frame.world_from_wheel, RationalVector{Rational(0), Rational(0), Rational(z)});
  const RationalVector base = exactly(ask.frame.position_in_world);
  return {base[0] + arm[0], base[1] + arm[1], base[2] + arm[2]};
}

}  // namespace groundtruth::cases::testing
