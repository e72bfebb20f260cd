#include <groundtruth/fast/step.hpp>

#include <groundtruth/fast/exact_stage/step.hpp>
#include <groundtruth/fast/quick_step.hpp>
#include <groundtruth/fast/step_decided.hpp>
#include <groundtruth/fast/step_ground.hpp>
#include <groundtruth/fast/step_numbers.hpp>

namespace groundtruth::fast {

namespace {

StepAnswer exactly(const Scene& scene, const StepAsk& ask) {
  SolidAlongStrut ground(scene);
  return exact_stage::step(scene, ground, ask);
}

GROUNDTRUTH_FUSED std::optional<StepAnswer> fused_answer(const Scene& scene, const StepAsk& ask) {
  return QuickStep<FusedPair>(scene, ask).answer();
}
GROUNDTRUTH_FLAT std::optional<StepAnswer> portable_answer(const Scene& scene, const StepAsk& ask) {
  return QuickStep<Pair>(scene, ask).answer();
}

std::optional<StepAnswer> quick_answer(const Scene& scene, const StepAsk& ask, Kernels kernels) {
  return kernels == Kernels::fused ? fused_answer(scene, ask) : portable_answer(scene, ask);
}

DecidedStep step_in_counted_pairs(const Scene& scene, const StepAsk& ask) {
  const auto plan = StepPlanner<Pair>(scene, ask).plan();
  if (!plan) return {exactly(scene, ask), Stage::exact, Stage::exact};
  if (const auto answer = StepNumbers<Pair>(ask, *plan).answer())
    return {*answer, Stage::double_pair, Stage::double_pair};
  return {exactly(scene, ask), Stage::double_pair, Stage::exact};
}

}  // namespace

DecidedStep decide_step(const Scene& scene, const StepAsk& ask, Kernels kernels) {
  auto quick = quick_answer(scene, ask, kernels);
  if (quick) return {*std::move(quick), Stage::doubles, Stage::quick_pair};
  return step_in_counted_pairs(scene, ask);
}

StepAnswer step(const Scene& scene, const StepAsk& ask) {
  if (auto quick = quick_answer(scene, ask, best_kernels())) return *std::move(quick);
  return step_in_counted_pairs(scene, ask).answer;
}

}  // namespace groundtruth::fast
