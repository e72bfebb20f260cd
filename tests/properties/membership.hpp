#pragma once
// Membership and material straight from SPEC section 2, on rationals: what laws measure the engines against.

#include <array>
#include <optional>

#include <boost/multiprecision/gmp.hpp>

#include <groundtruth/problem/ask.hpp>
#include <groundtruth/tests/properties/shapes.hpp>

namespace groundtruth::properties {

using Rational = boost::multiprecision::mpq_rational;
using Point = std::array<Rational, 3>;

Point point(const Vector& vector);
Point point_at(const EntryAsk& ask, const Rational& lambda);

Rational delta(const HalfSpace& half_space, const Point& point);
bool contains(const Shape& shape, const Point& point);

// What the boundary point `point`, reported on this leaf, is made of; absent: nothing in particular.
std::optional<MaterialIndex> material_of(const Shape& shape, Leaf leaf, const Point& point);

}  // namespace groundtruth::properties
