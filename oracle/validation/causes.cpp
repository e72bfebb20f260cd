#include <groundtruth/validation/causes.hpp>

#include <groundtruth/implementations/engine.hpp>
#include <groundtruth/validation/examination.hpp>

namespace groundtruth::validation {
namespace {

constexpr std::size_t most_groups = 6;

std::string kind_of(const Finding& finding) {
  if (finding.outcome != Outcome::wrong) return std::string(name_of(finding.outcome));
  return std::string(judge::name_of(finding.verdict.difference));
}

class Questioner {
 public:
  Questioner(implementations::Subject& subject, const SearchPlan& plan) : subject_(subject), plan_(plan) {}

  Finding ask(const cases::Case& with) const {
    Batch batch;
    batch.scene = std::make_shared<const Scene>(with.scene);
    batch.asks = {with.ask};
    batch.ids = {with.id};
    return examine(batch, {true, true, true}, plan_.tolerance, subject_).front();
  }

  // Which cases fail as this failure does.
  diagnosis::StillFail like(const diagnosis::Failure& failure) const {
    return [this, kind = failure.kind](std::span<const cases::Case> candidates) {
      std::vector<bool> fails;
      for (const cases::Case& candidate : candidates)
        fails.push_back(kind != name_of(Outcome::hung) && kind_of(ask(candidate)) == kind);
      return fails;
    };
  }

 private:
  implementations::Subject& subject_;
  const SearchPlan& plan_;
};

// What rounding alone may turn says nothing about an error, if there are other witnesses.
bool is_safe_from_rounding(const diagnosis::Witness& witness) {
  static const auto doubles = implementations::make_engine("double");
  const Answer answer = doubles->on(witness.asked.scene)->answer(witness.asked.ask).answer;
  return judge::Judge(witness.asked.scene, judge::find_profile("double")->tolerance)
      .judge(witness.asked.ask, answer)
      .is_accepted();
}

std::vector<diagnosis::Witness> witnesses_of(const std::vector<Failure>& findings) {
  constexpr std::size_t most_looked_at = 400;
  std::vector<diagnosis::Witness> safe, all;
  for (const Failure& one : findings) {
    if (one.finding.reply.kind != implementations::ReplyKind::answered) continue;
    all.push_back({one.asked, one.finding.reply.answer, one.finding.verdict.exact});
    if (all.size() <= most_looked_at && is_safe_from_rounding(all.back())) safe.push_back(all.back());
  }
  return safe.empty() ? all : safe;
}

}  // namespace

Causes causes_of(const std::vector<Failure>& failures, const std::vector<Failure>& accepted,
                 implementations::Subject& subject, const SearchPlan& plan) {
  const Questioner questioner(subject, plan);
  std::vector<diagnosis::Failure> told;
  for (const Failure& failure : failures) told.push_back({failure.asked, kind_of(failure.finding)});
  diagnosis::GroupBudget budget;
  budget.most_groups = most_groups;
  budget.of_one.most_time = plan.time / (2 * most_groups);
  Causes causes;
  const auto like = [&](const diagnosis::Failure& failure) { return questioner.like(failure); };
  for (diagnosis::Group& group : diagnosis::gather(told, like, budget)) {
    const Failure& first = failures[group.members.front()];
    const cases::Case smallest = group.representative.smallest;
    const bool is_hung = first.finding.outcome == Outcome::hung;
    causes.groups.push_back(
        {std::move(group), is_hung ? first : Failure{0, smallest, questioner.ask(smallest)}});
  }
  causes.diagnosis = diagnosis::diagnose(witnesses_of(failures), witnesses_of(accepted));
  return causes;
}

}  // namespace groundtruth::validation
