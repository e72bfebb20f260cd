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

// Both require that the segment's line crosses the plane, and that the exact lambda lies between two doubles.
RoundedLambda exact_crossing(const HalfSpace& leaf, const EntryAsk& ask);

// In double-double if that can tell, else exactly.
inline RoundedLambda correctly_rounded_crossing(const CellKernels& kernels, const HalfSpace& leaf,
                                                const EntryAsk& ask) {
  const auto& [n, d] = leaf;
  const RoundedCrossing crossing =
      kernels.rounded_crossing(n[0], n[1], n[2], d, ask.from.data(), ask.to.data());
  if (crossing.is_certain) return {crossing.lambda, Stage::double_pair};
  return exact_crossing(leaf, ask);
}

}  // namespace groundtruth::fast
