#pragma once
// Vectors of exact numbers, and doubles as such. Not installed.

#include <algorithm>
#include <array>

#include <groundtruth/fast/exact_stage/dyadic.hpp>
#include <groundtruth/fast/exact_stage/fixed.hpp>
#include <groundtruth/problem/shape.hpp>

namespace groundtruth::fast::exact_stage {

template <class Number>
using Normal = std::array<Number, 3>;

template <class Number>
Normal<Number> cross(const Normal<Number>& a, const Normal<Number>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class Number>
Number dot(const Normal<Number>& a, const Normal<Number>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Normal<Dyadic> dyadic_normal(const HalfSpace& leaf) {
  return {leaf.normal[0], leaf.normal[1], leaf.normal[2]};
}

// The powers of two between which the bits of some doubles lie.
class BitRange {
 public:
  void add(double x) {
    const SplitDouble parts = split(x);
    const auto magnitude = static_cast<std::uint64_t>(parts.mantissa < 0 ? -parts.mantissa : parts.mantissa);
    const int highest = parts.exponent + static_cast<int>(std::bit_width(magnitude));
    lowest_ = std::min(lowest_, magnitude == 0 ? none_below : parts.exponent);
    highest_ = std::max(highest_, magnitude == 0 ? -none_below : highest);
  }
  void add(const Vector& v) {
    for (const double x : v) add(x);
  }

  bool is_empty() const { return lowest_ == none_below; }
  // Of no bits: 0.
  int lowest() const { return is_empty() ? 0 : lowest_; }
  int highest() const { return is_empty() ? 0 : highest_; }
  // Above a place of value 2^unit.
  int bits_above(int unit) const { return is_empty() ? 0 : highest_ - unit; }

 private:
  static constexpr int none_below = 100000;
  int lowest_ = none_below;
  int highest_ = -none_below;
};

// x / 2^unit. Requires that this is an integer, and fits.
template <std::size_t words>
Fixed<words> in_units(double x, int unit) {
  const SplitDouble parts = split(x);
  return Fixed<words>(parts.mantissa).shifted(parts.mantissa == 0 ? 0 : parts.exponent - unit);
}

template <std::size_t words>
Normal<Fixed<words>> in_units(const Vector& v, int unit) {
  return {in_units<words>(v[0], unit), in_units<words>(v[1], unit), in_units<words>(v[2], unit)};
}

}  // namespace groundtruth::fast::exact_stage
