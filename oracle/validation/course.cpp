#include <groundtruth/validation/course.hpp>

#include <algorithm>

#include <groundtruth/cases/corpus.hpp>

namespace groundtruth::validation {
namespace {

constexpr std::uint64_t failures_of_endless_strands = 10;

std::vector<cases::Case> share_of_corpus(const Selection& selection) {
  const std::vector<cases::Case>& corpus = cases::corpus();
  const std::uint64_t end = std::min<std::uint64_t>(corpus.size(), selection.cases.value_or(corpus.size()));
  std::vector<cases::Case> share;
  for (std::uint64_t i = selection.shard.index - 1; i < end; i += selection.shard.count) {
    share.push_back(corpus[i]);
  }
  return share;
}

std::uint64_t generated_cases(const Selection& selection) {
  const std::uint64_t corpus = cases::corpus().size();
  return *selection.cases > corpus ? *selection.cases - corpus : 0;
}

// Shared out over the strands, so that where one stops does not depend on the others.
std::uint64_t most_failures_of_strand(const Selection& selection) {
  if (selection.most_failures == 0) return 0;
  if (!selection.cases) return failures_of_endless_strands;
  const std::uint64_t strands =
      std::max<std::uint64_t>(1, (generated_cases(selection) + cases_of_strand - 1) / cases_of_strand);
  return (selection.most_failures + strands - 1) / strands;
}

std::unique_ptr<Stream> strand_at(const Selection& selection, std::uint64_t number) {
  StrandPlan plan{selection.seed, number, cases_of_strand, most_failures_of_strand(selection),
                  selection.shares};
  if (selection.cases) {
    const std::uint64_t all = generated_cases(selection);
    const std::uint64_t before = number * cases_of_strand;
    if (before >= all) return nullptr;
    plan.cases = std::min(cases_of_strand, all - before);
  }
  return strand_of(plan);
}

}  // namespace

StreamAt course_of(const Selection& selection) {
  return [selection](std::size_t stream) -> std::unique_ptr<Stream> {
    if (stream == 0) return stream_of(share_of_corpus(selection));
    const Shares& shares = selection.shares;
    if (shares.entry + shares.clip + shares.step == 0) return nullptr;
    return strand_at(selection, (stream - 1) * selection.shard.count + selection.shard.index - 1);
  };
}

}  // namespace groundtruth::validation
