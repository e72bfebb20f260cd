#include <groundtruth/validation/conclusion.hpp>

#include <algorithm>

namespace groundtruth::validation {

Conclusion conclude(const Tally& tally, const std::vector<Record>& records) {
  const auto any = [&](const auto& is_so) {
    return std::any_of(records.begin(), records.end(), [&](const Record& record) {
      return record.expectation != Expectation::known && is_so(record);
    });
  };
  const auto disagrees = [](const Record& record) {
    return record.outcome == Outcome::wrong || record.expectation == Expectation::passes ||
           record.expectation == Expectation::changed;
  };
  const auto broke_down = [](const Record& record) {
    return record.outcome == Outcome::crashed || record.outcome == Outcome::hung;
  };
  if (any(disagrees)) return Conclusion::disagrees;
  if (any(broke_down)) return Conclusion::broke_down;
  if (any([](const Record&) { return true; })) return Conclusion::unreadable;
  return tally.judged() == 0 ? Conclusion::nothing_judged : Conclusion::agrees;
}

std::string_view in_words(Conclusion conclusion) {
  switch (conclusion) {
    case Conclusion::agrees:
      return "AGREES";
    case Conclusion::disagrees:
      return "DISAGREES";
    case Conclusion::unreadable:
      return "UNREADABLE ANSWERS";
    case Conclusion::broke_down:
      return "CRASHES OR HANGS";
    default:
      return "NOTHING COULD BE JUDGED";
  }
}

}  // namespace groundtruth::validation
