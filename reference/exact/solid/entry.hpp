#pragma once
// Phi in exact arithmetic, on any segment whose start is a sum of roots and whose direction is rational: what
// a wheel's step asks. An entry ask is the case without roots. Private to this folder.

#include <array>
#include <optional>
#include <vector>

#include <groundtruth/exact/arithmetic/root_sum.hpp>
#include <groundtruth/exact/solid/solid.hpp>

namespace groundtruth::exact {

// x(lambda) = origin + lambda direction, lambda in [first, last]. Number is Rational or RootSum.
template <typename Number>
struct Segment {
  std::array<Number, 3> origin;
  RationalVector direction;
  Rational first = 0;
  Rational last = 1;
};

template <typename Number>
struct Entry {
  Number lambda;
  std::array<Number, 3> point;
  bool interior = false;
  std::vector<Leaf> admissible;  // ascending; empty iff interior
};

// Absent: a miss.
template <typename Number>
std::optional<Entry<Number>> find_entry(const Solid& solid, const Segment<Number>& segment);

// The material of a boundary point that is reported on this leaf (SPEC section 2).
template <typename Number>
std::optional<MaterialIndex> material_at(const Ground& ground, Leaf leaf, const std::array<Number, 3>& point);

}  // namespace groundtruth::exact
