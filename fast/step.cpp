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

}  // namespace

DecidedStep decide_step(const Scene& scene, const StepAsk& ask) {
  Stage stage = Stage::doubles;
  auto plan = StepPlanner<double>(scene, ask).plan();
  if (!plan) {
    stage = Stage::double_pair;
    plan = StepPlanner<Pair>(scene, ask).plan();
  }
  if (!plan) return {exactly(scene, ask), Stage::exact, Stage::exact};
  if (const auto answer = StepNumbers<Pair>(ask, *plan).answer()) return {*answer, stage, Stage::double_pair};
  return {exactly(scene, ask), stage, Stage::exact};
}

StepAnswer step(const Scene& scene, const StepAsk& ask) { return decide_step(scene, ask).answer; }

}  // namespace groundtruth::fast
