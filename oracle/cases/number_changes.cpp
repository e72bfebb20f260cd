#include "number_changes.hpp"

#include <utility>

namespace groundtruth::cases {
namespace {

double finite_or(double value, double otherwise) { return std::isfinite(value) ? value : otherwise; }

}  // namespace

double changed_number(double value, Random& random) {
  switch (random.below(8)) {
    case 0:
    case 1:
      return finite_or(std::nextafter(value, random.sign() * HUGE_VAL), value);
    case 2:
      return 0 - value;
    case 3:
      return finite_or(std::ldexp(value, static_cast<int>(random.between(-4, 4))), value);
    case 4:
      return 0;
    case 5:
      return finite_or(std::rint(value), value);
    case 6:
      return finite_or(value + random.dyadic(-2, 2, 1), value);
    default: {
      const double sign = random.sign();
      const auto bits = static_cast<int>(random.between(8, 50));
      return finite_or(value * (1 + sign * std::ldexp(1.0, -bits)), value);
    }
  }
}

Vector changed_vector(const Vector& value, Random& random) {
  Vector result = value;
  const std::size_t axis = random.below(3);
  switch (random.below(5)) {
    case 0:
      for (double& coordinate : result) coordinate = one_ulp_off(coordinate, random);
      return result;
    case 1:
      result[axis] = result[random.below(3)];
      return result;
    case 2:
      std::swap(result[axis], result[random.below(3)]);
      return result;
    default:
      result[axis] = changed_number(result[axis], random);
      return result;
  }
}

}  // namespace groundtruth::cases
