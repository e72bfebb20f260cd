#pragma once
// A clip ask on the exact engine's own numbers, seen in the surface's plane. Axes x and y of the plane are
// kept without roots, r X and r ||n|| Y, so that only the clipped force bears any.

#include <groundtruth/exact/wheel/clipping.hpp>
#include <groundtruth/tests/properties/generators.hpp>
#include <groundtruth/tests/properties/membership.hpp>

namespace groundtruth::properties {

// A force in the surface's plane by x = F.(r X) and y = F.(r ||n|| Y), with what measures them.
struct Tangent {
  Rational x, y;
  Rational x_weight, y_weight;  // 1 / r^2 and 1 / (r ||n||)^2

  Rational along_x_squared() const { return x * x * x_weight; }
  Rational squared() const { return along_x_squared() + y * y * y_weight; }
};
Tangent operator+(const Tangent& a, const Tangent& b);
Tangent operator-(const Tangent& a, const Tangent& b);
Rational dot(const Tangent& a, const Tangent& b);

class ExactCase {
 public:
  // Requires an upright surface.
  explicit ExactCase(const ClipAsk& ask);

  Tangent tangent(const Rational& x, const Rational& y) const;
  Tangent force() const { return seen(force_); }
  // The clipped force; roots are enclosed in intervals of 2^-bits, of which this is one end.
  Tangent clipped(unsigned bits) const;
  // The point of the way from 0 to `aim` that is farthest from 0 and in the border, or one close to it.
  Tangent drawn_into_border(const Tangent& aim) const;

  std::array<exact::RootSum, 3> force_in_wheel() const { return clip_.force_in_wheel.components(); }
  bool normal_part_is_kept() const;

  // The same but for a force that is x (r X) + y (r ||n|| Y) greater.
  ExactCase pushed(const Rational& x, const Rational& y) const;
  ExactCase with_opposite_tangential_part() const;
  bool clips_opposite_to(const ExactCase& other) const;

  const Rational& brake() const { return border_.brake; }
  Rational brake_squared() const { return border_.brake * border_.brake; }
  Rational disc_squared() const;
  // Of the force, the border and the plane's axes: an upper bound for the squares of what the tests compute
  // with.
  Rational scale_squared() const;

 private:
  ExactCase(const exact::RationalVector& force, const exact::RationalVector& normal,
            const exact::PebbleBorder& border);
  exact::RationalVector x_axis() const { return {-normal_.z(), 0, normal_.x()}; }
  exact::RationalVector y_axis() const;
  exact::RationalVector normal_part() const {
    return normal_ * Rational((force_ * normal_) / (normal_ * normal_));
  }
  Tangent seen(const exact::RationalVector& force) const {
    return tangent(force * x_axis(), force * y_axis());
  }

  exact::RationalVector force_, normal_;
  exact::PebbleBorder border_;
  exact::ExactClip clip_;
};

}  // namespace groundtruth::properties
