#pragma once
// What came of one case.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <groundtruth/cases/case.hpp>
#include <groundtruth/implementations/subject.hpp>
#include <groundtruth/judge/verdict.hpp>
#include <groundtruth/validation/case_name.hpp>

namespace groundtruth::validation {

enum class Outcome { accepted, wrong, crashed, hung, unreadable, skipped };
inline constexpr std::size_t number_of_outcomes = 6;

std::string_view name_of(Outcome outcome);
std::optional<Outcome> outcome_named(std::string_view name);

inline bool is_failure(Outcome outcome) {
  return outcome != Outcome::accepted && outcome != Outcome::skipped;
}

struct Finding {
  std::uint64_t ask_number = 0;  // in its stream, from 0
  Outcome outcome = Outcome::accepted;
  judge::Verdict verdict;  // bears the exact answer, whatever the outcome but skipped
  implementations::Reply reply;
  double seconds = 0;  // its share of the batch's
};

// In one line: what is wrong with it; empty if it was accepted or skipped.
const std::string& explanation_of(const Finding& finding);

Kind kind_of_ask(const Ask& ask);

// How many cases of each kind came to what.
class Tally {
 public:
  void add(Kind kind, Outcome outcome, std::uint64_t count = 1) { at(kind, outcome) += count; }
  void merge(const Tally& other);

  std::uint64_t count(Kind kind, Outcome outcome) const {
    return counts_[static_cast<std::size_t>(kind)][static_cast<std::size_t>(outcome)];
  }
  std::uint64_t count(Outcome outcome) const;
  // All but the skipped.
  std::uint64_t judged(Kind kind) const;
  std::uint64_t judged() const;

 private:
  std::uint64_t& at(Kind kind, Outcome outcome) {
    return counts_[static_cast<std::size_t>(kind)][static_cast<std::size_t>(outcome)];
  }
  std::array<std::array<std::uint64_t, number_of_outcomes>, number_of_kinds> counts_{};
};

}  // namespace groundtruth::validation
