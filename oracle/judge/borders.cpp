#include "borders.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace groundtruth::judge {
namespace {

double rounded(long double value, double towards) {
  const long double capped =
      std::clamp(value, 0.0L, static_cast<long double>(std::numeric_limits<double>::max()));
  const double nearest = static_cast<double>(capped);
  const bool rounded_back = towards > 0 ? nearest < capped : nearest > capped;
  return rounded_back ? std::nextafter(nearest, towards) : nearest;
}

}  // namespace

std::array<BorderNumbers, 4> borders_around(const BorderNumbers& border, long double pressing,
                                            long double change) {
  const double infinity = std::numeric_limits<double>::infinity();
  // A hair more, for what `pressing` itself is rounded by.
  const long double of_friction = change * 1.001L / pressing;
  const double more_friction =
      change == 0 ? border.friction : rounded(border.friction + of_friction, infinity);
  const double less_friction =
      change == 0 ? border.friction : rounded(border.friction - of_friction, -infinity);
  const double more_brake = rounded(border.brake + change, infinity);
  const double less_brake = rounded(border.brake - change, -infinity);
  return {{{more_friction, more_brake},
           {less_friction, less_brake},
           {more_friction, less_brake},
           {less_friction, more_brake}}};
}

}  // namespace groundtruth::judge
