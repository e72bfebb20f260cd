#pragma once
// Exact arithmetic and walks over scenes for the tests of the generators.

#include <array>
#include <cmath>
#include <functional>
#include <type_traits>
#include <variant>
#include <vector>

#include <boost/multiprecision/cpp_int.hpp>

#include <groundtruth/problem/ask.hpp>
#include <groundtruth/problem/scene.hpp>

namespace groundtruth::cases::testing {

using Rational = boost::multiprecision::cpp_rational;
using RationalVector = std::array<Rational, 3>;

inline RationalVector exactly(const Vector& v) { return {Rational(v[0]), Rational(v[1]), Rational(v[2])}; }

inline RationalVector minus(const RationalVector& a, const RationalVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline Rational dot(const RationalVector& a, const RationalVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline RationalVector cross(const RationalVector& a, const RationalVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline bool is_zero(const RationalVector& v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; }

// The signed distance of SPEC section 2, times the normal's length.
inline Rational delta(const HalfSpace& half_space, const RationalVector& point) {
  return dot(exactly(half_space.normal), point) - Rational(half_space.offset);
}

inline RationalVector point_at(const EntryAsk& ask, double lambda) {
  const RationalVector from = exactly(ask.from);
  const RationalVector along = minus(exactly(ask.to), from);
  const Rational l(lambda);
  return {from[0] + l * along[0], from[1] + l * along[1], from[2] + l * along[2]};
}

// q v q^-1
inline RationalVector rotated(const Quaternion& q, const RationalVector& v) {
  const Rational w(q[0]);
  const RationalVector axis{Rational(q[1]), Rational(q[2]), Rational(q[3])};
  const Rational square = w * w + dot(axis, axis);
  const Rational shrink = w * w - dot(axis, axis);
  const Rational along = 2 * dot(axis, v);
  const RationalVector turn = cross(axis, v);
  RationalVector result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = (shrink * v[i] + along * axis[i] + 2 * w * turn[i]) / square;
  }
  return result;
}

inline Quaternion inverse(const Quaternion& q) { return {q[0], -q[1], -q[2], -q[3]}; }

// Every half-space of the shape, and those of paint's regions, in the order in which they stand.
inline void for_each_half_space(const Shape& shape, const std::function<void(const HalfSpace&)>& visit) {
  std::visit(
      [&](const auto& expression) {
        using Expression = std::decay_t<decltype(expression)>;
        if constexpr (std::is_same_v<Expression, HalfSpace>) {
          visit(expression);
        } else if constexpr (std::is_same_v<Expression, Union> || std::is_same_v<Expression, Intersection>) {
          for (const Shape& operand : expression.operands) for_each_half_space(operand, visit);
        } else if constexpr (std::is_same_v<Expression, Covered>) {
          for_each_half_space(*expression.over, visit);
        } else if constexpr (std::is_same_v<Expression, Painted>) {
          for_each_half_space(*expression.where, visit);
          for_each_half_space(*expression.over, visit);
        }
      },
      shape.expression);
}

inline std::vector<HalfSpace> half_spaces_of(const Shape& shape) {
  std::vector<HalfSpace> result;
  for_each_half_space(shape, [&](const HalfSpace& half_space) { result.push_back(half_space); });
  return result;
}

}  // namespace groundtruth::cases::testing
