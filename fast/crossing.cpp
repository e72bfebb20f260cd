#include <groundtruth/fast/crossing.hpp>

#include <groundtruth/fast/exact_stage/entry.hpp>

namespace groundtruth::fast {

RoundedLambda correctly_rounded_crossing(const CellKernels& kernels, const HalfSpace& leaf,
                                         const EntryAsk& ask) {
  const RoundedCrossing crossing =
      kernels.rounded_crossing(leaf.normal.data(), leaf.offset, ask.from.data(), ask.to.data());
  if (crossing.is_certain) return {crossing.lambda, Stage::double_pair};
  return {exact_stage::crossing(leaf, ask), Stage::exact};
}

}  // namespace groundtruth::fast
