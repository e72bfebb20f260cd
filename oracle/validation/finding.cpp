#include <groundtruth/validation/finding.hpp>

namespace groundtruth::validation {
namespace {

constexpr std::array<std::string_view, number_of_outcomes> outcomes{"accepted", "wrong",      "crashed",
                                                                    "hung",     "unreadable", "skipped"};

}  // namespace

std::string_view name_of(Outcome outcome) { return outcomes[static_cast<std::size_t>(outcome)]; }

std::optional<Outcome> outcome_named(std::string_view name) {
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    if (outcomes[i] == name) return static_cast<Outcome>(i);
  }
  return std::nullopt;
}

const std::string& explanation_of(const Finding& finding) {
  return finding.outcome == Outcome::wrong ? finding.verdict.explanation : finding.reply.detail;
}

Kind kind_of_ask(const Ask& ask) { return static_cast<Kind>(ask.index()); }

void Tally::merge(const Tally& other) {
  for (std::size_t kind = 0; kind < counts_.size(); ++kind) {
    for (std::size_t i = 0; i < number_of_outcomes; ++i) counts_[kind][i] += other.counts_[kind][i];
  }
}

std::uint64_t Tally::count(Outcome outcome) const {
  std::uint64_t sum = 0;
  for (const auto& of_kind : counts_) sum += of_kind[static_cast<std::size_t>(outcome)];
  return sum;
}

std::uint64_t Tally::judged(Kind kind) const {
  std::uint64_t sum = 0;
  for (const std::uint64_t count : counts_[static_cast<std::size_t>(kind)]) sum += count;
  return sum - count(kind, Outcome::skipped);
}

std::uint64_t Tally::judged() const { return judged(Kind::entry) + judged(Kind::clip) + judged(Kind::step); }

}  // namespace groundtruth::validation
