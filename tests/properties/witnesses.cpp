#include <groundtruth/tests/properties/witnesses.hpp>

#include <ostream>

#include <groundtruth/definition/clip.hpp>
#include <groundtruth/definition/entry_point.hpp>
#include <groundtruth/definition/step.hpp>
#include <groundtruth/exact/clip.hpp>
#include <groundtruth/exact/entry_point.hpp>
#include <groundtruth/exact/step.hpp>
#include <groundtruth/text/answer_text.hpp>
#include <groundtruth/text/ask_text.hpp>

namespace groundtruth::properties {
namespace {

const std::string case_id = "\"case\"";

[[noreturn]] void disagree(const Scene& scene, const Ask& ask, const Answer& exact,
                           const Evidence& exact_evidence, const Answer& definition,
                           const Evidence& definition_evidence) {
  throw Disagreement("exact and definition disagree:\n" + replay(scene, ask) +
                     "\nexact:      " + write_answer(case_id, exact, exact_evidence, scene) +
                     "\ndefinition: " + write_answer(case_id, definition, definition_evidence, scene));
}

Scene bare() { return {{}, {Nothing{}}}; }

}  // namespace

std::string replay(const Scene& scene, const Ask& ask) {
  return write_scene_line(scene) + "\n" + write_ask(case_id, ask);
}

bool operator==(const Entered& left, const Entered& right) {
  return left.answer == right.answer && left.lambda == right.lambda && left.admissible == right.admissible;
}

std::ostream& operator<<(std::ostream& out, const Entered& entered) {
  constexpr const char* kinds[] = {"miss", "inside", "border"};
  out << kinds[entered.answer.index()];
  if (entered.lambda) out << " at " << *entered.lambda;
  for (const Leaf leaf : entered.admissible) out << " leaf " << leaf;
  return out;
}

bool same_place(const Entered& left, const Entered& right) {
  return left.answer.index() == right.answer.index() && left.lambda == right.lambda;
}

std::vector<Material> palette() {
  return {{"dry", {{"rubber", {0.5, 0.375}}}, std::nullopt},
          {"metal-only", {{"metal", {0.5, 0.25}}}, std::nullopt},
          {"soft", {{"rubber", {0.75, 0.5}}}, 6},
          {"ice", {{"rubber", {0.25, 0}}}, std::nullopt}};
}

Ground::Ground(Scene scene) : scene_(std::move(scene)), exact_(scene_), definition_(scene_) {}

Entered Ground::entry(const EntryAsk& ask) const {
  const auto exact = exact::entry_point(exact_, ask);
  const auto definition = definition::entry_point(definition_, ask);
  const bool agree = exact.answer == definition.answer &&
                     exact.evidence.lambda_exact == definition.evidence.lambda_exact &&
                     exact.evidence.admissible == definition.evidence.admissible;
  if (!agree) disagree(scene_, ask, exact.answer, exact.evidence, definition.answer, definition.evidence);
  Entered entered{exact.answer, std::nullopt, exact.evidence.admissible};
  if (!exact.evidence.lambda_exact.empty()) entered.lambda = Rational(exact.evidence.lambda_exact);
  return entered;
}

StepAnswer Ground::step(const StepAsk& ask) const {
  const StepAnswer exact = exact::step(exact_, ask).answer;
  const StepAnswer definition = definition::step(definition_, ask);
  // The wording of a refusal is free.
  const bool both_refuse =
      std::holds_alternative<Refusal>(exact) && std::holds_alternative<Refusal>(definition);
  if (!both_refuse && !(exact == definition)) disagree(scene_, ask, exact, {}, definition, {});
  return exact;
}

ClipAnswer clip(const ClipAsk& ask) {
  const ClipAnswer exact = exact::clip(ask).answer;
  const ClipAnswer definition = definition::clip(ask);
  const bool both_refuse =
      std::holds_alternative<Refusal>(exact) && std::holds_alternative<Refusal>(definition);
  if (!both_refuse && !(exact == definition)) disagree(bare(), ask, exact, {}, definition, {});
  return exact;
}

}  // namespace groundtruth::properties
