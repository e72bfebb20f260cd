#include <cmath>
#include <cstring>
#include <limits>

#include <groundtruth/cases/random.hpp>

namespace groundtruth::cases {

std::uint64_t Random::below(std::uint64_t count) {
  // The largest multiple of count below 2^64: beyond it the remainders would not be uniform.
  const std::uint64_t excess = (std::numeric_limits<std::uint64_t>::max() % count + 1) % count;
  const std::uint64_t last = std::numeric_limits<std::uint64_t>::max() - excess;
  std::uint64_t drawn = bits();
  while (drawn > last) drawn = bits();
  return drawn % count;
}

std::int64_t Random::between(std::int64_t first, std::int64_t last) {
  const auto span = static_cast<std::uint64_t>(last - first) + 1;
  return first + static_cast<std::int64_t>(below(span));
}

double Random::unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

double Random::dyadic(std::int64_t low, std::int64_t high, int fraction_bits) {
  const std::int64_t one = std::int64_t{1} << fraction_bits;
  return std::ldexp(static_cast<double>(between(low * one, high * one)), -fraction_bits);
}

double Random::magnitude(int first_exponent, int last_exponent) {
  const double mantissa = 1.0 + unit();
  return std::ldexp(mantissa, static_cast<int>(between(first_exponent, last_exponent)));
}

// Two rounds of the finaliser of SplitMix64.
std::uint64_t seed_of_part(std::uint64_t seed, std::uint64_t index) {
  const auto mixed = [](std::uint64_t z) {
    z += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  };
  return mixed(mixed(seed) ^ index);
}

namespace {

double from_bits(std::uint64_t bits) {
  double value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

double any_finite(Random& random) {
  const std::uint64_t sign_and_fraction = random.bits() & 0x800fffffffffffffu;
  return from_bits(sign_and_fraction | (random.below(0x7ff) << 52));
}

}  // namespace

double bit_pattern_double(Random& random) {
  const double sign = random.sign();
  switch (random.below(8)) {
    case 0:
      return sign * 0.0;
    case 1: {
      const std::int64_t leading_zeros = random.between(12, 63);
      return sign * from_bits(random.bits() >> leading_zeros);
    }
    case 2:
      return sign * static_cast<double>(random.below(17));
    case 3:
      return one_ulp_off(sign * static_cast<double>(random.below(17)), random);
    case 4: {
      const auto numerator = static_cast<double>(random.below(1024));
      return sign * std::ldexp(numerator, static_cast<int>(random.between(-60, 60)));
    }
    case 5:
      return any_finite(random);
    default:
      return sign * random.magnitude(-20, 20);
  }
}

double one_ulp_off(double value, Random& random) {
  const std::uint64_t choice = random.below(3);
  if (choice == 0) return value;
  const double direction = choice == 1 ? 1.0 : -1.0;
  if (value == 0 && random.one_in(2)) return direction * 0x1p-52;
  return std::nextafter(value, direction * std::numeric_limits<double>::max());
}

Vector one_ulp_off(const Vector& value, Random& random) {
  return Vector{one_ulp_off(value[0], random), one_ulp_off(value[1], random), one_ulp_off(value[2], random)};
}

}  // namespace groundtruth::cases
