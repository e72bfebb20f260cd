#pragma once
// Where a slipping pebble goes, in double-double under one bound for the ask: lemma strut-in-pairs,
// proofs-notes/rounding-of-forces.md, section 11. Not installed.
//
// Whatever rounds is false where that is uncertain. `support` gives where the exact vector may differ from 0.

#include <groundtruth/fast/quick_strut.hpp>

namespace groundtruth::fast {

// As Load::relocated (step_load.hpp).
template <class Pair>
QuickOffset<Pair> relocated(const StepAsk& ask, const QuickLoad<Pair>& load, const Vector3<Pair>& clipped,
                            double error) {
  const double k_xy = ask.wheel.k_xy, d_xy = ask.wheel.d_xy, h = ask.h, force_scale = 0x1p84 * error;
  const bool is_usable = is_in_window(std::abs(k_xy)) && is_in_window(h);
  if (!is_usable) return {{}, std::numeric_limits<double>::infinity()};
  if (ask.wheel.relocation == Relocation::spring) {
    const double inverse = 1 / k_xy;
    const auto axis = [&](std::size_t k) { return quotient(clipped[k], Pair(k_xy), inverse); };
    return {{axis(0), axis(1), axis(2)}, std::abs(force_scale * inverse)};
  }
  const Pair stiffness = Pair::product(h, k_xy) + Pair(d_xy);
  const double inverse = 1 / stiffness.high;
  const auto axis = [&](std::size_t k) {
    const Pair moved = load.arm()[k] - h * load.velocity()[k];
    return quotient(h * clipped[k] + d_xy * moved, stiffness, inverse);
  };
  const double moved_size = load.arm_size() + h * load.velocity_size();
  return {{axis(0), axis(1), axis(2)}, std::abs((h * force_scale + std::abs(d_xy) * moved_size) * inverse)};
}

template <class Pair, class GivesSupport>
bool place_pebble(const Vector& frame_in_world, const QuickLanding<Pair>& landing,
                  const GivesSupport& support, Vector& pebble) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (k == landing.level_axis) {
      pebble[k] = landing.level;
      continue;
    }
    const double b = frame_in_world[k];
    const Pair& way = landing.from_frame_in_world[k];
    const double error = landing.error + 0x1p-100 * (std::abs(b) + std::abs(way.high));
    const auto place = nearest_double(Pair::loose_sum(b, way), error);
    if (!place && (b != 0 || support().has(k))) return false;
    pebble[k] = place ? *place : 0;
  }
  return true;
}

// The velocity that takes it from the old place to the new one in a step.
template <class Pair, class GivesSupport>
bool move_pebble(double h, const QuickLanding<Pair>& landing, const Vector& old_pebble,
                 const QuickLoad<Pair>& load, const GivesSupport& support, Vector& velocity) {
  const double inverse = 1 / h;
  for (std::size_t k = 0; k < 3; ++k) {
    const bool is_level = k == landing.level_axis;
    const Pair& to = landing.from_frame_in_world[k];
    const Pair& from = load.arm()[k];
    const Pair moved = is_level ? Pair::sum(landing.level, -old_pebble[k]) : Pair::loose_sum(to, -from);
    if (is_level && moved.high == 0) {
      velocity[k] = 0;
      continue;
    }
    const double of_ends = is_level ? 0 : landing.error + 0x1p-97 * (std::abs(to.high) + std::abs(from.high));
    const double error = of_ends + (0x1p-97 * std::abs(moved.high) + 0x1p-1000);
    const auto speed = nearest_double(quotient(moved, Pair(h), inverse), 2 * (error * inverse));
    if (!speed && support().has(k)) return false;
    velocity[k] = speed ? *speed : 0;
  }
  return true;
}

}  // namespace groundtruth::fast
