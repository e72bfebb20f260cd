#pragma once
// Asks as integers of a fixed length: multiples of powers of two. Not installed.

#include <cmath>
#include <optional>

#include <groundtruth/fast/exact_stage/lines.hpp>
#include <groundtruth/fast/exact_stage/normal.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::fast::exact_stage {

// The powers of two in which an ask's numbers are counted, and how long they are then.
class Units {
 public:
  explicit Units(const EntryAsk& ask);

  int point() const { return point_; }    // of coordinates: an exponent of two
  int lambda() const { return lambda_; }  // <= 0

  // Of a leaf's normal: so small a unit that the offset, too, is a multiple of it times the point's; and how
  // many bits, without the sign, hold the value and slope of the leaf's line then: lemma lattice-bits
  // (proofs-notes/rounding.md).
  struct OfLeaf {
    int unit;
    int bits;
  };
  OfLeaf of(const HalfSpace& leaf) const;
  // As many hold all numbers of the ask itself.
  int bits() const { return bits_of(point_bits_); }

 private:
  int bits_of(int term) const { return term + lambda_bits_ + 3; }

  int point_ = 0;
  int point_bits_ = 0;
  int lambda_ = 0;
  int lambda_bits_ = 0;
};

// Requires that the bits of the ask and of all leaves are at most Fixed<words>::bits.
template <std::size_t words>
class Lattice {
 public:
  Lattice(const EntryAsk& ask, const Units& units)
      : units_(units),
        start_(in_units<words>(ask.from, units.point())),
        lambda_first_(in_units<words>(ask.lambda_first, units.lambda())),
        lambda_last_(in_units<words>(ask.lambda_last, units.lambda())) {
    const Normal<Fixed<words>> end = in_units<words>(ask.to, units.point());
    for (std::size_t axis = 0; axis < 3; ++axis) direction_[axis] = end[axis] - start_[axis];
  }

  // `unit`: of the leaf. From the start of the range on; t is lambda - first in the units of lambda.
  Line<FixedNumbers<words>> line(const HalfSpace& leaf, int unit) const {
    const Normal<Fixed<words>> normal = in_units<words>(leaf.normal, unit);
    const Fixed<words> slope = dot(normal, direction_);
    const Fixed<words> value = dot(normal, start_) - in_units<words>(leaf.offset, units_.point() + unit);
    return {value.shifted(-units_.lambda()) + lambda_first_ * slope, slope, slope.sign()};
  }
  Fixed<words> length() const { return lambda_last_ - lambda_first_; }
  // Correctly rounded, if the machine's division does it: both its terms are doubles. Requires slope != 0.
  std::optional<double> lambda(const Line<FixedNumbers<words>>& line) const {
    const auto numerator = exact_double(lambda_first_ * line.slope - line.value);
    const auto denominator = exact_double(line.slope);
    if (!numerator || !denominator) return std::nullopt;
    return std::ldexp(*numerator / *denominator, units_.lambda()) + 0.0;
  }

 private:
  const Units& units_;
  Normal<Fixed<words>> start_;  // x(lambda = 0)
  Normal<Fixed<words>> direction_;
  Fixed<words> lambda_first_;
  Fixed<words> lambda_last_;
};

}  // namespace groundtruth::fast::exact_stage
