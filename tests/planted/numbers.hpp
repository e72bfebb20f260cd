#pragma once
// Numbers of 50 digits, long enough that what is equal exactly can be told from what is an ulp apart, and
// places that are exact.

#include <array>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>

#include <groundtruth/problem/vector.hpp>

namespace groundtruth::planted {

using Number =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
using Numbers = std::array<Number, 3>;

using Rational = boost::multiprecision::cpp_rational;
using Place = std::array<Rational, 3>;

inline Place place(const Vector& vector) {
  return {Rational(vector[0]), Rational(vector[1]), Rational(vector[2])};
}

// -1, 0, 1 as a is less, equal, greater. What differs by less than 10^-35 of `scale` is equal.
inline int compare(const Number& a, const Number& b, const Number& scale) {
  const Number difference = a - b;
  if (abs(difference) <= scale * Number(1e-35)) return 0;
  return difference < 0 ? -1 : 1;
}
inline int compare(const Number& a, const Number& b) { return compare(a, b, abs(a) + abs(b)); }

inline Numbers numbers(const Vector& vector) {
  return {Number(vector[0]), Number(vector[1]), Number(vector[2])};
}
template <typename Long>
Vector doubles(const std::array<Long, 3>& a) {
  return {static_cast<double>(a[0]), static_cast<double>(a[1]), static_cast<double>(a[2])};
}

inline Numbers operator+(const Numbers& a, const Numbers& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Numbers operator-(const Numbers& a, const Numbers& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Numbers operator*(const Number& s, const Numbers& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline Number dot(const Numbers& a, const Numbers& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Number length(const Numbers& a) { return sqrt(dot(a, a)); }
inline Numbers cross(const Numbers& a, const Numbers& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// f_q of a quaternion of any length.
class Turn {
 public:
  explicit Turn(const Quaternion& q)
      : scalar_(q[0]),
        vector_(numbers({q[1], q[2], q[3]})),
        squared_(scalar_ * scalar_ + dot(vector_, vector_)) {}
  Numbers operator()(const Numbers& v) const { return turned(v, scalar_); }
  Numbers inverse(const Numbers& v) const { return turned(v, -scalar_); }

 private:
  Numbers turned(const Numbers& v, const Number& scalar) const {
    const Numbers twice = Number(2) * cross(vector_, v);
    return v + (Number(1) / squared_) * (scalar * twice + cross(vector_, twice));
  }

  Number scalar_;
  Numbers vector_;
  Number squared_;
};

}  // namespace groundtruth::planted
