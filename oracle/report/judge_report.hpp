#pragma once
// What `groundtruth judge` shows.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <groundtruth/judge/verdict.hpp>

namespace groundtruth::report {

enum class Judged {
  accepted,
  wrong,
  skipped,    // no line answers the ask
  unreadable  // the line that answers it is none
};

inline constexpr std::size_t number_of_judged = 4;

std::string_view name_of(Judged judged);

struct JudgedAsk {
  std::string id;     // JSON
  std::string kind;   // "entry", "clip", "step"; "bad" for a line that is no ask
  std::string place;  // of the ask: "asks.jsonl:7"
  Judged judged = Judged::accepted;
  judge::Verdict verdict;   // of an ask that was judged
  std::string explanation;  // one line; empty if accepted
  std::string exact;        // JSON: {"answer": ...} or {"error": ...}; empty if nothing was judged
};

// "asks.jsonl:7 "a1": wrong lambda: ...".
std::string line_of(const JudgedAsk& asked);

// One JSON object.
std::string json_of(const JudgedAsk& asked);

// The last line of the JSON: {"summary": {"accepted": 12, ..., "left_over": 0}}, where `left_over` counts the
// answers to what was not asked.
std::string json_summary_of(const std::vector<JudgedAsk>& asked, std::size_t left_over);

// A row a kind of ask, and the differences of the wrong ones.
std::string table_of(const std::vector<JudgedAsk>& asked);

}  // namespace groundtruth::report
