#pragma once
// The inner loops, once for every x86-64 and once for those that have AVX2 and FMA. Not installed.
//
// Both give the same Meetings bit for bit: the same operations in the same order, each
// rounded, none fused. A rounded crossing is the exact one's nearest double wherever it is certain; only how
// often it is certain may differ, where products underflow.

#include <cstdint>

#include <groundtruth/fast/box_way.hpp>
#include <groundtruth/fast/hierarchy.hpp>
#include <groundtruth/fast/search_task.hpp>

namespace groundtruth::fast {

struct RoundedCrossing {
  double lambda = 0;
  bool is_certain = false;
};

// What is left to be searched.
enum class Left { nothing, hierarchy };

struct CellKernels {
  // These add to task.result what the range may meet first of some parts: those apart and, if the range is
  // over few squares of the grid, those over these; those listed; those in a hierarchy, of which the first
  // node is the root. The last requires coordinates that box-slabs allows.
  Left (*visit_near)(SearchTask& task);
  void (*visit_parts)(SearchTask& task, const Part* first, const Part* end);
  void (*visit_hierarchy)(SearchTask& task, const BoxNode* nodes, const BoxWay& way);
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
