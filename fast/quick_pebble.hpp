#pragma once
// Where a slipping pebble goes, in double-double under one bound for the ask: lemma strut-in-pairs,
// proofs-notes/rounding-of-forces.md, section 11. Not installed.
//
// Whatever rounds is false where that is uncertain. `support` gives where the exact vector may differ from 0.

#include <groundtruth/fast/quick_strut.hpp>

namespace groundtruth::fast {

// As Load::relocated (step_load.hpp).
template <class Pair>
QuickOffset<Pair> relocated(const StepAsk& ask, const QuickLoad<Pair>& load, const Pairs3<Pair>& clipped,
                            double error) {
  using Pairs = Pairs3<Pair>;
  const double k_xy = ask.wheel.k_xy, d_xy = ask.wheel.d_xy, h = ask.h, force_scale = 0x1p84 * error;
  const bool is_usable = is_in_window(std::abs(k_xy)) && is_in_window(h);
  if (!is_usable) return {{}, std::numeric_limits<double>::infinity()};
  if (ask.wheel.relocation == Relocation::spring) {
    const double inverse = 1 / k_xy;
    return {quotient<Pairs>(clipped, Pair(k_xy), inverse), std::abs(force_scale * inverse)};
  }
  const Pair stiffness = Pair::product(h, k_xy) + Pair(d_xy);
  const double inverse = 1 / stiffness.high;
  const Pairs moved = load.arm() - h * load.velocity();
  const double moved_size = load.arm_size() + h * load.velocity_size();
  return {quotient<Pairs>(h * clipped + d_xy * moved, stiffness, inverse),
          std::abs((h * force_scale + std::abs(d_xy) * moved_size) * inverse)};
}

template <class Pair, class GivesSupport>
bool place_pebble(const Vector& frame_in_world, const QuickLanding<Pair>& landing,
                  const GivesSupport& support, Vector& pebble) {
  const Pairs3<Pair>& way = landing.from_frame_in_world;
  const Doubles3<Pair> frame(frame_in_world);
  const auto places = nearest_doubles(Pairs3<Pair>::loose_sum(frame, way),
                                      landing.error + 0x1p-100 * (magnitude(frame) + magnitude(way.high)));
  pebble = Vector(places.nearest);
  const unsigned certain = places.certain | landing.level_bit();
  const auto of_place = [&] { return Support(frame_in_world) | support(); };
  if (certain != places.everywhere && !put_zeros(certain, of_place, pebble)) return false;
  if (landing.level_axis != landing.no_axis) pebble[landing.level_axis] = landing.level;
  return true;
}

// Along the axis to which planes are level: from and to are known.
template <class Pair>
std::optional<double> level_speed(double h, double from, double to) {
  const Pair moved = Pair::sum(to, -from);
  if (moved.high == 0) return 0;
  const double inverse = 1 / h, error = 0x1p-97 * std::abs(moved.high) + 0x1p-1000;
  return nearest_double(quotient(moved, Pair(h), inverse), 2 * (error * inverse));
}

// The velocity that takes it from the old place to the new one in a step.
template <class Pair, class GivesSupport>
bool move_pebble(double h, const QuickLanding<Pair>& landing, const Vector& old_pebble,
                 const QuickLoad<Pair>& load, const GivesSupport& support, Vector& velocity) {
  using Pairs = Pairs3<Pair>;
  const Pairs &to = landing.from_frame_in_world, &from = load.arm();
  const Pairs moved = Pairs::loose_sum(to, -from);
  const double inverse = 1 / h;
  const auto of_ends = landing.error + 0x1p-97 * (magnitude(to.high) + magnitude(from.high));
  const auto error = of_ends + (0x1p-97 * magnitude(moved.high) + 0x1p-1000);
  const auto speeds = nearest_doubles(quotient<Pairs>(moved, Pair(h), inverse), 2 * (error * inverse));
  velocity = Vector(speeds.nearest);
  const unsigned certain = speeds.certain | landing.level_bit();
  if (certain != speeds.everywhere && !put_zeros(certain, support, velocity)) return false;
  if (landing.level_axis == landing.no_axis) return true;
  const auto speed = level_speed<Pair>(h, old_pebble[landing.level_axis], landing.level);
  if (!speed) return false;
  velocity[landing.level_axis] = *speed;
  return true;
}

}  // namespace groundtruth::fast
