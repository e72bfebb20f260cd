#pragma once
// The inner loops, once for every x86-64 and once for those that have AVX2 and FMA. Not installed.
//
// Both give the same Meetings bit for bit: the same operations in the same order, each
// rounded, none fused. A rounded crossing is the exact one's nearest double wherever it is certain; only how
// often it is certain may differ, where products underflow.

#include <cstdint>

#include <groundtruth/fast/box_way.hpp>
#include <groundtruth/fast/hierarchy.hpp>
#include <groundtruth/fast/meeting.hpp>
#include <groundtruth/fast/parts.hpp>

namespace groundtruth::fast {

// The ends of a range, and a bound of the error of every Delta (lemma clip-interval, cell.hpp).
struct CertifiedEnds {
  const double* first;
  const double* last;
  double error;
};

struct RoundedCrossing {
  double lambda = 0;
  bool is_certain = false;
};

struct CellKernels {
  // Requires a usable error bound.
  Meeting (*meet)(const HalfSpaces4* group, const HalfSpaces4* end, const CertifiedEnds& ends);
  // The children of a node that may be met no later than `upper`, as bits, and where first.
  unsigned (*meet_boxes)(const BoxNode& node, const BoxWay& way, float upper, float* nearest);
  // Lemma crossing-in-double-double (proofs-notes/rounding.md). from, to: three numbers each.
  RoundedCrossing (*rounded_crossing)(double normal_x, double normal_y, double normal_z, double offset,
                                      const double* from, const double* to);
};

extern const CellKernels portable_cell_kernels;

// The quickest that this processor can run.
const CellKernels& best_cell_kernels();

}  // namespace groundtruth::fast
