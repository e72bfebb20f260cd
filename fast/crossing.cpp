#include <groundtruth/fast/crossing.hpp>

#include <groundtruth/fast/exact_stage/entry.hpp>

namespace groundtruth::fast {

RoundedLambda correctly_rounded_crossing(const CellKernels& kernels, const HalfSpace& leaf,
                                         const EntryAsk& ask) {
  const auto& [n, d] = leaf;
  const RoundedCrossing crossing =
      kernels.rounded_crossing(n[0], n[1], n[2], d, ask.from.data(), ask.to.data());
  if (crossing.is_certain) return {crossing.lambda, Stage::double_pair};
  return {exact_stage::crossing(leaf, ask), Stage::exact};
}

}  // namespace groundtruth::fast
