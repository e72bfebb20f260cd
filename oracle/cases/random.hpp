#pragma once
// Random numbers that are the same on every platform: std::mt19937_64, whose bits the standard fixes, and
// mappings of our own, because those of std::*_distribution differ between libraries.
//
// Callers must not draw twice in one expression whose order C++ leaves open (f(r.unit(), r.unit()),
// r.sign() * r.unit()): draw in statements, or in braces, which go from left to right.

#include <cstdint>
#include <iterator>
#include <random>

#include <groundtruth/problem/vector.hpp>

namespace groundtruth::cases {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  std::uint64_t bits() { return engine_(); }

  // Uniform in [0, count). Requires count > 0.
  std::uint64_t below(std::uint64_t count);

  // Uniform in [first, last]. Requires first <= last and last - first < 2^63.
  std::int64_t between(std::int64_t first, std::int64_t last);

  // True with probability 1/count. Requires count > 0.
  bool one_in(std::uint64_t count) { return below(count) == 0; }

  // 1 or -1.
  double sign() { return one_in(2) ? 1.0 : -1.0; }

  // Uniform multiples of 2^-53 in [0, 1).
  double unit();

  // low + unit() (high - low), rounded. Requires that high - low does not overflow.
  double uniform(double low, double high) { return low + unit() * (high - low); }

  // A multiple of 2^-fraction_bits in [low, high], so that arithmetic on it stays exact. Requires low <=
  // high.
  double dyadic(std::int64_t low, std::int64_t high, int fraction_bits);

  // A positive number with uniform binary exponent in [first_exponent, last_exponent].
  double magnitude(int first_exponent, int last_exponent);

  // An element of a non-empty container.
  template <class Container>
  const auto& pick(const Container& container) {
    return *std::next(std::begin(container), static_cast<std::ptrdiff_t>(below(std::size(container))));
  }

 private:
  std::mt19937_64 engine_;
};

// A seed for part `index` of what `seed` stands for; parts are as good as independent.
std::uint64_t seed_of_part(std::uint64_t seed, std::uint64_t index);

// Any finite double, with weight on what breaks arithmetic: zeros of both signs, subnormals, all exponents,
// small integers and their neighbours, short dyadics.
double bit_pattern_double(Random& random);

// `value` or one of the two doubles next to it, each with probability 1/3. Next to zero are the smallest
// subnormals or, as often, +-2^-52, the ulp of 1. Finite if `value` is not the largest double.
double one_ulp_off(double value, Random& random);
Vector one_ulp_off(const Vector& value, Random& random);

}  // namespace groundtruth::cases
