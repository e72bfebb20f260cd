#include <groundtruth/explanation/explanation.hpp>

#include <algorithm>

#include <groundtruth/implementations/engine.hpp>
#include <groundtruth/implementations/errata.hpp>
#include <groundtruth/judge/difference.hpp>
#include <groundtruth/judge/finite.hpp>
#include <groundtruth/text/answer_text.hpp>
#include <groundtruth/tiers/tier.hpp>

#include "wording.hpp"

namespace groundtruth::explanation {
namespace {

using implementations::Answered;

class FactsOfAsk {
 public:
  FactsOfAsk(const Scene& scene, const Answer& answer) : scene_(scene), answer_(answer) {}

  Facts operator()(const EntryAsk& ask) const {
    return facts_of(scene_, {rational(ask.from), minus(rational(ask.to), rational(ask.from)),
                             Rational(ask.lambda_first), Rational(ask.lambda_last)});
  }
  Facts operator()(const ClipAsk& ask) const { return facts_of(ask); }
  Facts operator()(const StepAsk& ask) const { return facts_of(scene_, ask, std::get<StepAnswer>(answer_)); }

 private:
  const Scene& scene_;
  const Answer& answer_;
};

Opinion opinion_of(const std::string& who, const Answered& said, const cases::Case& asked,
                   const Answered& exact) {
  const judge::Comparison compared =
      judge::compare({said.answer, said.evidence}, {exact.answer, exact.evidence});
  const bool same = compared.difference == judge::Difference::none;
  return {who, write_answer("null", said.answer, said.evidence, asked.scene),
          same ? "" : "differs in " + std::string(judge::name_of(compared.difference))};
}

Opinion opinion_of_engine(const std::string& engine, const cases::Case& asked, const Answered& exact) {
  return opinion_of(engine, implementations::make_engine(engine)->on(asked.scene)->answer(asked.ask), asked,
                    exact);
}

Opinion opinion_of_tier(const tiers::Row& row, const cases::Case& asked, const Answered& exact) {
  if (const auto* omitted = std::get_if<tiers::Omitted>(&row.said))
    return {row.name, "", "does not answer this: " + omitted->reason};
  const Answer* answer = std::get_if<Answer>(&row.said);
  if (answer == nullptr) return {row.name, "", "is undecided"};
  if (!judge::has_only_finite_numbers(*answer)) return {row.name, "", "has a number that is not finite"};
  return opinion_of(row.name, {*answer, {}}, asked, exact);
}

}  // namespace

Explanation explain(const cases::Case& asked) {
  const Answered exact = implementations::make_engine("exact")->on(asked.scene)->answer(asked.ask);
  Explanation explanation{asked,
                          exact.answer,
                          exact.evidence,
                          write_answer("null", exact.answer, exact.evidence, asked.scene),
                          in_words(exact.answer, exact.evidence, asked.scene),
                          std::visit(FactsOfAsk(asked.scene, exact.answer), asked.ask),
                          {}};
  const std::vector<std::string> engines = implementations::engine_names();
  for (const std::string& engine : engines)
    explanation.opinions.push_back(opinion_of_engine(engine, asked, exact));
  for (const tiers::Row& row : tiers::rows_for(asked.scene, asked.ask)) {
    if (std::find(engines.begin(), engines.end(), row.name) == engines.end())
      explanation.opinions.push_back(opinion_of_tier(row, asked, exact));
  }
  for (const std::string& erratum : implementations::erratum_names())
    explanation.opinions.push_back(opinion_of_engine("as-written:" + erratum, asked, exact));
  return explanation;
}

}  // namespace groundtruth::explanation
