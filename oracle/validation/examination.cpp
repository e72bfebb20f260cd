#include <groundtruth/validation/examination.hpp>

#include <utility>

#include <groundtruth/judge/verdict.hpp>

namespace groundtruth::validation {
namespace {

using implementations::Reply;
using implementations::ReplyKind;
using Clock = std::chrono::steady_clock;

Outcome outcome_of(const Reply& reply, const judge::Verdict& verdict) {
  switch (reply.kind) {
    case ReplyKind::crashed:
      return Outcome::crashed;
    case ReplyKind::hung:
      return Outcome::hung;
    case ReplyKind::unreadable:
      return Outcome::unreadable;
    default:
      return verdict.is_accepted() ? Outcome::accepted : Outcome::wrong;
  }
}

// A refusal as good as any, where there is no answer to hold against the exact one.
Answer answer_in(const Reply& reply) {
  if (reply.kind == ReplyKind::answered) return reply.answer;
  return ClipAnswer{Refusal{reply.detail}};
}

}  // namespace

std::vector<Finding> examine(const Batch& batch, const Kinds& kinds, const judge::Tolerance& tolerance,
                             implementations::Subject& subject) {
  std::vector<Finding> findings(batch.asks.size());
  std::vector<Ask> asks;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < batch.asks.size(); ++i) {
    findings[i].outcome = Outcome::skipped;
    if (!kinds[batch.asks[i].index()]) continue;
    asks.push_back(batch.asks[i]);
    places.push_back(i);
  }
  if (asks.empty()) return findings;
  const auto start = Clock::now();
  std::vector<Reply> replies = subject.ask(*batch.scene, asks);
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  const judge::Judge judge(*batch.scene, tolerance);
  for (std::size_t k = 0; k < asks.size(); ++k) {
    Finding& finding = findings[places[k]];
    finding.verdict = judge.judge(asks[k], answer_in(replies[k]));
    finding.outcome = outcome_of(replies[k], finding.verdict);
    finding.reply = std::move(replies[k]);
    finding.seconds = seconds / static_cast<double>(asks.size());
  }
  return findings;
}

}  // namespace groundtruth::validation
