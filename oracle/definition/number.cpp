#include <cmath>
#include <cstdint>
#include <cstdlib>

#include <groundtruth/definition/number.hpp>

namespace groundtruth::definition {

Integer power_of_two(unsigned exponent) {
  Integer result;
  bit_set(result, exponent);
  return result;
}

Rational rational(double value) {
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  const Integer mantissa = static_cast<std::int64_t>(std::ldexp(fraction, 53));
  exponent -= 53;
  const Integer scale = power_of_two(static_cast<unsigned>(std::abs(exponent)));
  return exponent >= 0 ? Rational(Integer(mantissa * scale)) : Rational(mantissa, scale);
}

Triple<Rational> rational(const Vector& vector) {
  return {rational(vector[0]), rational(vector[1]), rational(vector[2])};
}

}  // namespace groundtruth::definition
