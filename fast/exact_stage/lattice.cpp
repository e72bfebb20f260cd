#include <groundtruth/fast/exact_stage/lattice.hpp>

namespace groundtruth::fast::exact_stage {

Units::Units(const EntryAsk& ask) {
  BitRange points, lambdas;
  points.add(ask.from);
  points.add(ask.to);
  lambdas.add(ask.lambda_first);
  lambdas.add(ask.lambda_last);
  point_ = points.lowest();
  point_bits_ = points.bits_above(point_);
  lambda_ = std::min(lambdas.lowest(), 0);
  lambda_bits_ = std::max(lambdas.highest(), 0) - lambda_ + 1;
}

Units::LeafBits::LeafBits(const HalfSpace& leaf, int point_unit) {
  normal.add(leaf.normal);
  offset.add(leaf.offset);
  const int offset_unit = offset.lowest() - point_unit;
  unit = offset.is_empty()   ? normal.lowest()
         : normal.is_empty() ? offset_unit
                             : std::min(normal.lowest(), offset_unit);
}

int Units::bits(const HalfSpace& leaf) const {
  const LeafBits of(leaf, point_);
  return bits_of(
      std::max(of.normal.bits_above(of.unit) + point_bits_, of.offset.bits_above(point_ + of.unit)));
}

}  // namespace groundtruth::fast::exact_stage
