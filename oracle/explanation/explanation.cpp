#include <groundtruth/explanation/explanation.hpp>

#include <groundtruth/implementations/engine.hpp>
#include <groundtruth/implementations/errata.hpp>
#include <groundtruth/judge/difference.hpp>
#include <groundtruth/text/answer_text.hpp>

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

Opinion opinion_of(const std::string& engine, const cases::Case& asked, const Answered& exact) {
  const Answered said = implementations::make_engine(engine)->on(asked.scene)->answer(asked.ask);
  const judge::Comparison compared =
      judge::compare({said.answer, said.evidence}, {exact.answer, exact.evidence});
  const bool same = compared.difference == judge::Difference::none;
  return {engine, write_answer("null", said.answer, said.evidence, asked.scene),
          same ? "" : std::string(judge::name_of(compared.difference))};
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
  std::vector<std::string> engines = implementations::engine_names();
  for (const std::string& erratum : implementations::erratum_names())
    engines.push_back("as-written:" + erratum);
  for (const std::string& engine : engines) explanation.opinions.push_back(opinion_of(engine, asked, exact));
  return explanation;
}

}  // namespace groundtruth::explanation
