#include "direction.hpp"

#include <cmath>

#include "number.hpp"

namespace groundtruth::judge {
namespace {

RationalVector cross(const RationalVector& a, const RationalVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Of any magnitude to one that can be squared.
std::array<long double, 3> of_unit_size(const Vector& v) {
  const long double size = std::hypot(static_cast<long double>(v[0]), static_cast<long double>(v[1]),
                                      static_cast<long double>(v[2]));
  if (size == 0) return {};
  return {v[0] / size, v[1] / size, v[2] / size};
}

}  // namespace

bool points_along(const Vector& got, const Vector& expected, double radians) {
  const RationalVector a = rational(got);
  const RationalVector b = rational(expected);
  const Rational along = dot(a, b);
  if (along <= 0) return false;
  const RationalVector aside = cross(a, b);
  const Rational tangent = radians > 0 ? rational(std::tan(radians)) : Rational(0);
  return dot(aside, aside) <= tangent * tangent * along * along;
}

double degrees_between(const Vector& got, const Vector& expected) {
  const auto a = of_unit_size(got);
  const auto b = of_unit_size(expected);
  const long double apart = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  return static_cast<double>(2 * std::asin(std::fmin(apart / 2, 1.0L)) * 180 / std::acos(-1.0L));
}

}  // namespace groundtruth::judge
