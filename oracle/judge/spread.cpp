#include "spread.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace groundtruth::judge {

long double length(const Vector& vector) {
  return std::hypot(static_cast<long double>(vector[0]), static_cast<long double>(vector[1]),
                    static_cast<long double>(vector[2]));
}

void Spread::include(const Vector& vector) {
  for (std::size_t i = 0; i < 3; ++i) {
    low_[i] = std::min(low_[i], vector[i]);
    high_[i] = std::max(high_[i], vector[i]);
  }
}

long double Spread::distance_to(const Vector& vector) const {
  long double worst = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const long double below = static_cast<long double>(low_[i]) - vector[i];
    const long double above = static_cast<long double>(vector[i]) - high_[i];
    worst = std::max({worst, below, above});
  }
  return worst;
}

long double allowed(double relative, long double scale) {
  if (relative == 0) return 0;
  return relative * scale + 4 * static_cast<long double>(std::numeric_limits<double>::denorm_min());
}

}  // namespace groundtruth::judge
