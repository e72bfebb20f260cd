#pragma once
// Lambda where a segment crosses a plane, correctly rounded. Not installed.

#include <groundtruth/fast/cell_kernels.hpp>
#include <groundtruth/fast/stage.hpp>
#include <groundtruth/problem/ask.hpp>
#include <groundtruth/problem/shape.hpp>

namespace groundtruth::fast {

struct RoundedLambda {
  double value = 0;
  Stage stage = Stage::none;
};

// In double-double if that can tell, else exactly. Requires that the segment's line crosses the plane, and
// that the exact lambda lies between two doubles.
RoundedLambda correctly_rounded_crossing(const CellKernels& kernels, const HalfSpace& leaf,
                                         const EntryAsk& ask);

}  // namespace groundtruth::fast
