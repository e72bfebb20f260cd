#pragma once
// The exact numbers that the definition is evaluated in, and triples of them.

#include <array>
#include <cstddef>

#include <boost/multiprecision/cpp_int.hpp>

#include <groundtruth/problem/vector.hpp>

namespace groundtruth::definition {

using Integer =
    boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;
using Rational =
    boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;

template <class Number>
using Triple = std::array<Number, 3>;

Integer power_of_two(unsigned exponent);

// The value of a finite double.
Rational rational(double value);
Triple<Rational> rational(const Vector& vector);

template <class Left, class Right>
auto dot(const Triple<Left>& a, const Triple<Right>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Number>
Triple<Number> cross(const Triple<Number>& a, const Triple<Number>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class Left, class Right>
auto operator+(const Triple<Left>& a, const Triple<Right>& b) -> Triple<decltype(a[0] + b[0])> {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

template <class Left, class Right>
auto operator-(const Triple<Left>& a, const Triple<Right>& b) -> Triple<decltype(a[0] - b[0])> {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

template <class Number>
Triple<Number> operator-(const Triple<Number>& a) {
  return {-a[0], -a[1], -a[2]};
}

template <class Left, class Right>
auto operator*(const Left& factor, const Triple<Right>& a) -> Triple<decltype(factor * a[0])> {
  return {factor * a[0], factor * a[1], factor * a[2]};
}

}  // namespace groundtruth::definition
