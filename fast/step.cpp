#include <groundtruth/fast/step.hpp>

#include <groundtruth/fast/exact_stage/step.hpp>
#include <groundtruth/fast/step_decided.hpp>
#include <groundtruth/fast/step_ground.hpp>
#include <groundtruth/fast/step_numbers.hpp>

namespace groundtruth::fast {

namespace {

StepAnswer exactly(const Scene& scene, const StepAsk& ask) {
  SolidAlongStrut ground(scene);
  return exact_stage::step(scene, ground, ask);
}

GROUNDTRUTH_FUSED std::optional<StepAnswer> fused_answer(const StepAsk& ask, const StepPlan& plan) {
  return StepNumbers<FusedPair>(ask, plan).answer();
}

std::optional<StepAnswer> rounded_answer(const StepAsk& ask, const StepPlan& plan, Kernels kernels) {
  return kernels == Kernels::fused ? fused_answer(ask, plan) : StepNumbers<Pair>(ask, plan).answer();
}

}  // namespace

DecidedStep decide_step(const Scene& scene, const StepAsk& ask, Kernels kernels) {
  Stage stage = Stage::doubles;
  auto plan = StepPlanner<double>(scene, ask).plan();
  if (!plan) {
    stage = Stage::double_pair;
    plan = StepPlanner<Pair>(scene, ask).plan();
  }
  if (!plan) return {exactly(scene, ask), Stage::exact, Stage::exact};
  if (const auto answer = rounded_answer(ask, *plan, kernels)) return {*answer, stage, Stage::double_pair};
  return {exactly(scene, ask), stage, Stage::exact};
}

StepAnswer step(const Scene& scene, const StepAsk& ask) { return decide_step(scene, ask).answer; }

}  // namespace groundtruth::fast
