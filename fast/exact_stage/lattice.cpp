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

Units::OfLeaf Units::of(const HalfSpace& leaf) const {
  BitRange normal, offset;
  normal.add(leaf.normal);
  offset.add(leaf.offset);
  const int offset_unit = offset.lowest() - point_;
  const int unit = offset.is_empty()   ? normal.lowest()
                   : normal.is_empty() ? offset_unit
                                       : std::min(normal.lowest(), offset_unit);
  const int term = std::max(normal.bits_above(unit) + point_bits_, offset.bits_above(point_ + unit));
  return {unit, bits_of(term)};
}

}  // namespace groundtruth::fast::exact_stage
