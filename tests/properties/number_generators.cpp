#include <bit>
#include <cmath>
#include <limits>

#include <groundtruth/tests/properties/generators.hpp>

namespace groundtruth::properties {

double any_double(Dice& dice) {
  const double sign = dice.one_in(2) ? -1 : 1;
  switch (dice.whole(0, 7)) {
    case 0:
      return sign * 0.0;
    case 1:  // subnormal
      return sign * std::ldexp(static_cast<double>(dice.bits() >> 12), -1074);
    case 2:
      return sign * std::ldexp(1.0, dice.whole(-1074, 1023));
    case 3:
      return sign * dice.whole(0, 100);
    case 4:
      return sign * std::ldexp(static_cast<double>(dice.bits() >> 11), dice.whole(-60, -45));
    case 5: {  // the largest, or close
      const double shrunk = std::ldexp(static_cast<double>(dice.bits() >> 60), -53);
      return sign * std::numeric_limits<double>::max() * (1 - shrunk);
    }
    case 6:
      return std::nextafter(sign * std::ldexp(1.0, dice.whole(-1070, 1020)), sign * dice.whole(-1, 1));
    default: {
      const double any = std::bit_cast<double>(dice.bits());
      return std::isfinite(any) ? any : sign;
    }
  }
}

double wobbled(double value, Dice& dice, int odd_one_in) {
  if (dice.one_in(odd_one_in)) return any_double(dice);
  if (!dice.one_in(4)) return value;
  const double side = dice.one_in(2) ? 1 : -1;
  // A few ulps of a number about 1, as a computation that should give 0 would.
  if (value == 0) return side * dice.whole(1, 3) * 0x1p-52;
  for (int ulps = dice.whole(1, 3); ulps > 0; --ulps)
    value = std::nextafter(value, side * std::numeric_limits<double>::max());
  return value;
}

Vector lattice_vector(Dice& dice, int largest) {
  const auto coordinate = [&] { return static_cast<double>(dice.whole(-largest, largest)); };
  return {coordinate(), coordinate(), coordinate()};
}

Vector lattice_normal(Dice& dice) {
  Vector n{};
  if (dice.one_in(2)) {
    n[static_cast<std::size_t>(dice.whole(0, 2))] = dice.one_in(2) ? 1 : -1;
    return n;
  }
  return lattice_vector(dice, dice.whole(1, 2));
}

}  // namespace groundtruth::properties
