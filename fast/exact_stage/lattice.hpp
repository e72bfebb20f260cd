#pragma once
// An ask whose numbers are short multiples of powers of two, in machine integers. Not installed.

#include <span>

#include <groundtruth/fast/exact_stage/corner.hpp>

namespace groundtruth::fast::exact_stage {

class Lattice {
 public:
  // Nothing: some product would not fit.
  static std::optional<Lattice> of(const EntryAsk& ask, std::span<const HalfSpace> leaves);

  // From the start of the range on; t is lambda - first in units of 2^lambda_unit.
  Line<MachineNumbers> line(const HalfSpace& leaf) const;
  Normal<MachineInteger> normal(const HalfSpace& leaf) const;
  MachineInteger length() const { return lambda_last_ - lambda_first_; }
  // Correctly rounded. Requires slope != 0.
  double lambda(const Line<MachineNumbers>& line) const;

 private:
  Lattice() = default;

  int point_unit_ = 0;  // exponents of two
  int normal_unit_ = 0;
  int lambda_unit_ = 0;             // <= 0
  Normal<MachineInteger> start_{};  // x(lambda = 0)
  Normal<MachineInteger> direction_{};
  MachineInteger lambda_first_ = 0;
  MachineInteger lambda_last_ = 0;
};

}  // namespace groundtruth::fast::exact_stage
