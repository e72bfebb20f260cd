#pragma once
// Numbers a + b sqrt(A) + c sqrt(D) with rational a, b, c and a common pair A, D >= 0: where a slipping
// pebble goes (SPEC section 5). They form a vector space over the rationals, and Phi needs no more than that.

#include <array>
#include <memory>

#include <groundtruth/exact/arithmetic/rational.hpp>

namespace groundtruth::exact {

struct Radicands {
  Rational a;
  Rational d;
};

class RootSum {
 public:
  RootSum(Rational rational = 0) : rational_(std::move(rational)) {}
  RootSum(Rational rational, Rational times_root_a, Rational times_root_d,
          std::shared_ptr<const Radicands> radicands)
      : rational_(std::move(rational)),
        times_root_a_(std::move(times_root_a)),
        times_root_d_(std::move(times_root_d)),
        radicands_(std::move(radicands)) {}

  // Both operands bear the same radicands, or one of them is rational.
  friend RootSum operator+(const RootSum& left, const RootSum& right);
  friend RootSum operator-(const RootSum& left, const RootSum& right);
  friend RootSum operator*(const RootSum& left, const Rational& right);
  friend RootSum operator/(const RootSum& left, const Rational& right);

  bool is_rational() const { return times_root_a_.is_zero() && times_root_d_.is_zero(); }
  const Rational& rational_part() const { return rational_; }

  // -1, 0 or 1; by squaring, lemma sign-by-squares (proofs-notes/wheel.md, section 2).
  friend int sign(const RootSum& value);

  // Rationals lower <= value <= upper with upper - lower <= (|b| + |c|) / 2^bits.
  std::array<Rational, 2> enclosure(unsigned bits) const;

 private:
  Rational rational_;
  Rational times_root_a_ = 0;
  Rational times_root_d_ = 0;
  std::shared_ptr<const Radicands> radicands_;  // null for a rational
};

// u + v sqrt(A) + w sqrt(D).
struct RootVector {
  RationalVector u;
  RationalVector v = CGAL::NULL_VECTOR;
  RationalVector w = CGAL::NULL_VECTOR;
  std::shared_ptr<const Radicands> radicands = nullptr;

  std::array<RootSum, 3> components() const;
};

// The vector with `map`, linear over the rationals, applied to each part.
template <typename LinearMap>
RootVector transformed(const RootVector& vector, const LinearMap& map) {
  return {map(vector.u), map(vector.v), map(vector.w), vector.radicands};
}

}  // namespace groundtruth::exact
