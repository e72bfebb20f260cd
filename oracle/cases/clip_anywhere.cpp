// Clip asks that are not made to meet a border exactly.

#include <cmath>

#include <groundtruth/cases/border_cases.hpp>
#include <groundtruth/cases/clip_flavours.hpp>
#include <groundtruth/cases/vector_arithmetic.hpp>

namespace groundtruth::cases {
namespace {

Vector random_force(double size, Random& random) {
  return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

// Within about 40 degrees of upright, of any length.
Vector random_normal(Random& random) {
  const double tilt_x = random.uniform(-0.6, 0.6);
  const double tilt_y = random.uniform(-0.6, 0.6);
  const double size = random.one_in(2) ? 1.0 : random.magnitude(-3, 3);
  return times(size, {tilt_x, tilt_y, -1});
}

}  // namespace

ClipAsk clip_random(Random& random) {
  ClipAsk ask;
  const double size = random.one_in(4) ? random.magnitude(-30, 60) : random.magnitude(0, 17);
  ask.force_in_wheel = random_force(size, random);
  ask.normal_in_wheel = random_normal(random);
  ask.friction = random.one_in(4) ? random.uniform(0, 2) : random.pick(Vector{0.001, 0.1, 0.4});
  ask.brake = random.uniform(0, 0.5) * size;
  if (random.one_in(6)) {  // on either side of a limit of its own
    ask.min_uprightness = random.magnitude(-12, 6);
    Vector& normal = ask.normal_in_wheel;
    normal[2] = -ask.min_uprightness * std::hypot(normal[0], normal[1]) * random.uniform(0.5, 2);
  }
  return ask;
}

ClipAsk clip_hopeless_surface(Random& random) {
  ClipAsk ask = clip_random(random);
  Vector& normal = ask.normal_in_wheel;
  ask.min_uprightness = default_min_uprightness;
  const std::uint64_t what = random.below(4);
  if (what == 0) normal[2] = 0;
  if (what == 1) normal[2] = -normal[2];
  if (what == 2) normal[2] *= 0.001;
  if (what == 3) normal = {0, 0, 0};
  // The same ratio far from 1: squares of these leave the range of doubles.
  if (random.one_in(4)) normal = times(random.magnitude(-800, 800), normal);
  return ask;
}

ClipAsk clip_extreme_bits(Random& random) {
  const auto any_vector = [&] {
    return Vector{bit_pattern_double(random), bit_pattern_double(random), bit_pattern_double(random)};
  };
  ClipAsk ask;
  ask.force_in_wheel = any_vector();
  ask.normal_in_wheel = random.one_in(2) ? random_normal(random) : any_vector();
  ask.friction = std::abs(bit_pattern_double(random));
  ask.brake = std::abs(bit_pattern_double(random));
  if (random.one_in(2)) ask.min_uprightness = random.magnitude(-40, 4);
  return ask;
}

}  // namespace groundtruth::cases
