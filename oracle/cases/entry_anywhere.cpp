// Segments that are not made to meet a feature exactly.

#include <cmath>
#include <utility>

#include <groundtruth/cases/aim.hpp>
#include <groundtruth/cases/entry_flavours.hpp>
#include <groundtruth/cases/entry_passing.hpp>
#include <groundtruth/cases/vector_arithmetic.hpp>

namespace groundtruth::cases {

EntryAsk entry_random(const Landmarks& landmarks, Random& random) {
  EntryAsk ask;
  ask.from = in_bounds(landmarks, random);
  ask.to = in_bounds(landmarks, random);
  if (random.one_in(8)) {
    ask.lambda_first = random.uniform(-2, 2);
    ask.lambda_last = ask.lambda_first + random.uniform(0, 2);
  }
  return ask;
}

EntryAsk entry_strut(const Landmarks& landmarks, Random& random) {
  Vector middle = foothold(landmarks, random).point;
  // Away from the exact feature, by less than the strut's length.
  middle = plus(middle, {random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-1, 2)});
  const Vector down{random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), -1};
  const double half = random.uniform(0.5, 1.5);
  return {minus(middle, times(half, down)), plus(middle, times(half, down)), 0, 1};
}

EntryAsk entry_lattice(const Landmarks& landmarks, Random& random) {
  const int fraction_bits = static_cast<int>(random.below(3));
  EntryAsk ask;
  ask.from = lattice_point(landmarks, fraction_bits, random);
  ask.to = lattice_point(landmarks, fraction_bits, random);
  if (random.one_in(2)) ask.to = plus(ask.from, short_direction(random));
  return ask;
}

EntryAsk entry_from_afar(const Landmarks& landmarks, Random& random) {
  const Feature target = any_feature(landmarks, random);
  const double distance = std::ldexp(1.0, static_cast<int>(random.between(17, 27)));
  const Vector direction = outward_direction(target.normal, random);
  EntryAsk ask;
  ask.from = plus(target.point, times(distance, direction));
  ask.to = random.one_in(2) ? target.point : minus(target.point, times(distance, direction));
  return ask;
}

EntryAsk entry_extreme_bits(const Landmarks& landmarks, Random& random) {
  const auto any_vector = [&] {
    return Vector{bit_pattern_double(random), bit_pattern_double(random), bit_pattern_double(random)};
  };
  EntryAsk ask;
  ask.from = random.one_in(4) ? any_feature(landmarks, random).point : any_vector();
  ask.to = random.one_in(4) ? any_feature(landmarks, random).point : any_vector();
  if (random.one_in(4)) {
    ask.lambda_first = bit_pattern_double(random);
    ask.lambda_last = bit_pattern_double(random);
    if (ask.lambda_first > ask.lambda_last) std::swap(ask.lambda_first, ask.lambda_last);
  }
  return ask;
}

}  // namespace groundtruth::cases
