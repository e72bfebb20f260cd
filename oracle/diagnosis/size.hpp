#pragma once
// How large a case is, for those who shrink it and for those who have to read it.

#include <compare>
#include <cstddef>

#include <groundtruth/cases/case.hpp>

namespace groundtruth::diagnosis {

// Compared in this order.
struct Size {
  std::size_t parts =
      0;  // nodes of the shape, its regions included; two more for a contact, one for materials
  std::size_t leaves = 0;  // half-spaces
  double numbers = 0;      // what the numbers cost: 0 is free, 1 cheap, 53 random bits dear
  auto operator<=>(const Size&) const = default;
};

Size size_of(const cases::Case& with);

// 0 for 0, then 1, -1, other small integers, short dyadics, anything else.
double cost_of(double number);

}  // namespace groundtruth::diagnosis
