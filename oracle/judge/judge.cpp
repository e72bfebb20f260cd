#include <fmt/format.h>

#include <groundtruth/judge/finite.hpp>

#include "weigh.hpp"
#include "wording.hpp"

namespace groundtruth::judge {
namespace {

const Refusal* refusal_in(const Answer& answer) {
  if (const auto* clip = std::get_if<ClipAnswer>(&answer)) return std::get_if<Refusal>(clip);
  if (const auto* step = std::get_if<StepAnswer>(&answer)) return std::get_if<Refusal>(step);
  return nullptr;
}

Verdict not_of_this_kind(const Answer& got, const Answer& exact) {
  Verdict verdict;
  verdict.difference = refusal_in(got) != nullptr ? Difference::refusal : Difference::state;
  verdict.explanation = fmt::format("{} -> {}", kind_in_words(got), kind_in_words(exact));
  return verdict;
}

Verdict not_finite(const Answer& got) {
  Verdict verdict;
  verdict.difference = Difference::numbers;
  verdict.explanation = fmt::format("{} with a number that is not finite", kind_in_words(got));
  return verdict;
}

class Weigh {
 public:
  Weigh(const Truth& truth, const Ask& ask, const Answered& exact)
      : truth_(truth), ask_(ask), exact_(exact) {}

  Verdict operator()(const EntryAnswer& got) const {
    return weigh_entry(truth_, std::get<EntryAsk>(ask_), got, exact_);
  }
  Verdict operator()(const ClipAnswer& got) const {
    return weigh_clip(truth_, std::get<ClipAsk>(ask_), got, exact_);
  }
  Verdict operator()(const StepAnswer& got) const {
    return weigh_step(truth_, std::get<StepAsk>(ask_), got, exact_);
  }

 private:
  const Truth& truth_;
  const Ask& ask_;
  const Answered& exact_;
};

// A refusal is the same whatever the ask; as an answer to this ask.
Answer as_answer_to(const Ask& ask, const Answer& got) {
  const Refusal* refusal = refusal_in(got);
  if (refusal == nullptr || got.index() == ask.index()) return got;
  if (std::holds_alternative<ClipAsk>(ask)) return ClipAnswer{*refusal};
  if (std::holds_alternative<StepAsk>(ask)) return StepAnswer{*refusal};
  return got;
}

}  // namespace

class Judge::Scales : public Truth {
  using Truth::Truth;
};

Judge::Judge(const Scene& scene, const Tolerance& tolerance)
    : scales_(std::make_unique<const Scales>(scene, tolerance)) {}
Judge::Judge(Judge&&) noexcept = default;
Judge::~Judge() = default;

Verdict Judge::judge(const Ask& ask, const Answer& got) const {
  const Answered exact = scales_->answer(ask);
  const Answer answer = as_answer_to(ask, got);
  Verdict verdict = !has_only_finite_numbers(answer) ? not_finite(answer)
                    : answer.index() == ask.index()  ? std::visit(Weigh(*scales_, ask, exact), answer)
                                                     : not_of_this_kind(answer, exact.answer);
  verdict.exact = exact.answer;
  verdict.evidence = exact.evidence;
  return verdict;
}

}  // namespace groundtruth::judge
