#include <groundtruth/fast/step.hpp>

#include <groundtruth/fast/exact_stage/step.hpp>
#include <groundtruth/fast/number_traced.hpp>
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

GROUNDTRUTH_FUSED bool give_fused(const Scene& scene, const StepAsk& ask, StepAnswer& answer) {
  return QuickStep<FusedPair>(scene, ask).give(answer);
}
GROUNDTRUTH_FLAT bool give_portable(const Scene& scene, const StepAsk& ask, StepAnswer& answer) {
  return QuickStep<Pair>(scene, ask).give(answer);
}
bool give_quickly(const Scene& scene, const StepAsk& ask, Kernels kernels, StepAnswer& answer) {
  return kernels == Kernels::fused ? give_fused(scene, ask, answer) : give_portable(scene, ask, answer);
}

DecidedStep step_in_counted_pairs(const Scene& scene, const StepAsk& ask) {
  const auto plan = StepPlanner<Pair>(scene, ask).plan();
  if (!plan) return {exactly(scene, ask), Stage::exact, Stage::exact};
  if (const auto answer = StepNumbers<TracedPair>(ask, *plan).answer())
    return {*answer, Stage::double_pair, Stage::double_pair};
  return {exactly(scene, ask), Stage::double_pair, Stage::exact};
}

}  // namespace

DecidedStep decide_step(const Scene& scene, const StepAsk& ask, Kernels kernels) {
  DecidedStep quick{{}, Stage::doubles, Stage::quick_pair};
  if (give_quickly(scene, ask, kernels, quick.answer)) return quick;
  return step_in_counted_pairs(scene, ask);
}

StepAnswer step(const Scene& scene, const StepAsk& ask) {
  StepAnswer answer;
  if (!give_quickly(scene, ask, best_kernels(), answer)) answer = step_in_counted_pairs(scene, ask).answer;
  return answer;
}

}  // namespace groundtruth::fast
