#include <groundtruth/fast/exact_stage/lattice.hpp>

#include <cmath>

#include <groundtruth/fast/exact_stage/rounding.hpp>

namespace groundtruth::fast::exact_stage {

namespace {

// The powers of two between which the bits of some doubles lie.
class Bits {
 public:
  void add(double x) {
    const SplitDouble parts = split(x);
    if (parts.mantissa == 0) return;
    const auto magnitude = static_cast<std::uint64_t>(std::abs(parts.mantissa));
    lowest_ = std::min(lowest_, parts.exponent);
    highest_ = std::max(highest_, parts.exponent + static_cast<int>(std::bit_width(magnitude)));
  }
  void add(const Vector& v) {
    for (const double x : v) add(x);
  }
  void shift(int exponent) {
    if (highest_ == none_above) return;
    lowest_ += exponent;
    highest_ += exponent;
  }
  int lowest() const { return highest_ == none_above ? 0 : lowest_; }
  int highest() const { return highest_ == none_above ? 0 : highest_; }

 private:
  static constexpr int none_above = -100000;
  int lowest_ = 100000;
  int highest_ = none_above;
};

MachineInteger in_units(double x, int unit) {
  const SplitDouble parts = split(x);
  return parts.mantissa == 0
             ? 0
             : MachineInteger(parts.mantissa) * (MachineInteger(1) << (parts.exponent - unit));
}

Normal<MachineInteger> in_units(const Vector& v, int unit) {
  return {in_units(v[0], unit), in_units(v[1], unit), in_units(v[2], unit)};
}

Dyadic as_dyadic(MachineInteger x) { return {Integer(x), 0}; }

}  // namespace

// Bits of a line's value: three products and an offset of at most `terms` bits each take terms + 2, twice
// that length for a step from start to end adds 1, times lambda and its own sum 1 more. Determinants of two
// lines take twice as many and one, which must be at most 126.
std::optional<Lattice> Lattice::of(const EntryAsk& ask, std::span<const HalfSpace> leaves) {
  Bits points, normals, offsets, lambdas;
  points.add(ask.from);
  points.add(ask.to);
  lambdas.add(ask.lambda_first);
  lambdas.add(ask.lambda_last);
  for (const HalfSpace& leaf : leaves) {
    normals.add(leaf.normal);
    offsets.add(leaf.offset);
  }
  Lattice lattice;
  lattice.point_unit_ = points.lowest();
  offsets.shift(-lattice.point_unit_);
  lattice.normal_unit_ = std::min(normals.lowest(), offsets.lowest());
  lattice.lambda_unit_ = std::min(lambdas.lowest(), 0);
  const int normal_bits = std::max(0, normals.highest() - lattice.normal_unit_);
  const int point_bits = points.highest() - lattice.point_unit_;
  const int terms = std::max(normal_bits + point_bits, offsets.highest() - lattice.normal_unit_);
  const int lambda_bits = std::max(0, lambdas.highest()) - lattice.lambda_unit_ + 1;
  if (terms + lambda_bits + 5 > 62) return std::nullopt;
  lattice.start_ = in_units(ask.from, lattice.point_unit_);
  const Normal<MachineInteger> to = in_units(ask.to, lattice.point_unit_);
  for (std::size_t axis = 0; axis < 3; ++axis) lattice.direction_[axis] = to[axis] - lattice.start_[axis];
  lattice.lambda_first_ = in_units(ask.lambda_first, lattice.lambda_unit_);
  lattice.lambda_last_ = in_units(ask.lambda_last, lattice.lambda_unit_);
  return lattice;
}

Normal<MachineInteger> Lattice::normal(const HalfSpace& leaf) const {
  return in_units(leaf.normal, normal_unit_);
}

Line<MachineNumbers> Lattice::line(const HalfSpace& leaf) const {
  const Normal<MachineInteger> n = normal(leaf);
  const MachineInteger slope = dot(n, direction_);
  const MachineInteger value = dot(n, start_) - in_units(leaf.offset, point_unit_ + normal_unit_);
  return {value * (MachineInteger(1) << -lambda_unit_) + lambda_first_ * slope, slope,
          MachineNumbers{}.sign(slope)};
}

double Lattice::lambda(const Line<MachineNumbers>& line) const {
  MachineInteger numerator = lambda_first_ * line.slope - line.value, denominator = line.slope;
  if (denominator < 0) {
    numerator = -numerator;
    denominator = -denominator;
  }
  constexpr MachineInteger exact = MachineInteger(1) << 53;
  if (-exact < numerator && numerator < exact && denominator < exact)
    return std::ldexp(static_cast<double>(numerator) / static_cast<double>(denominator), lambda_unit_);
  return *nearest_double(as_dyadic(numerator).scaled(lambda_unit_), as_dyadic(denominator));
}

}  // namespace groundtruth::fast::exact_stage
