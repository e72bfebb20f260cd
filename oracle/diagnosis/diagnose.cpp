#include <groundtruth/diagnosis/diagnose.hpp>

#include <algorithm>

#include <groundtruth/diagnosis/resemblance.hpp>
#include <groundtruth/diagnosis/suspects.hpp>

namespace groundtruth::diagnosis {
namespace {

constexpr std::size_t most_witnesses = 60;  // of each list

double share(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

double weight(const Diagnosis& diagnosis) {
  return share(diagnosis.explained, diagnosis.failures) - share(diagnosis.contradicted, diagnosis.accepted);
}

class Trial {
 public:
  Trial(std::span<const Witness> failures, std::span<const Witness> accepted)
      : failures_(failures.first(std::min(failures.size(), most_witnesses))),
        accepted_(accepted.first(std::min(accepted.size(), most_witnesses))) {}

  // The heaviest of these suspects so far, an earlier one where several weigh alike.
  void hear(const std::vector<Suspect>& suspects) {
    for (const Suspect& suspect : suspects) {
      const Diagnosis diagnosis = weigh(suspect);
      if (!best_ || weight(diagnosis) > weight(*best_)) best_ = diagnosis;
    }
  }

  bool explains_nearly_all() const { return best_ && weight(*best_) >= 0.98; }

  std::optional<Diagnosis> verdict() const {
    const bool is_convicted =
        best_ && share(best_->explained, best_->failures) >= 0.9 && weight(*best_) >= 0.6;
    return is_convicted ? best_ : std::nullopt;
  }

 private:
  Diagnosis weigh(const Suspect& suspect) const {
    Diagnosis diagnosis{suspect.name, suspect.explanation, 0, failures_.size(), 0, accepted_.size()};
    for (const Witness& witness : failures_) diagnosis.explained += agrees(suspect, witness) ? 1 : 0;
    if (2 * diagnosis.explained < diagnosis.failures)
      return diagnosis;  // acquitted: the rest would not matter
    for (const Witness& witness : accepted_) diagnosis.contradicted += agrees(suspect, witness) ? 0 : 1;
    return diagnosis;
  }

  static bool agrees(const Suspect& suspect, const Witness& witness) {
    return resembles(suspect.answer(witness.asked.scene, witness.asked.ask), witness.got, witness.exact);
  }

  std::span<const Witness> failures_, accepted_;
  std::optional<Diagnosis> best_;
};

}  // namespace

std::optional<Diagnosis> diagnose(std::span<const Witness> failures, std::span<const Witness> accepted) {
  if (failures.empty()) return std::nullopt;
  Trial trial(failures, accepted);
  trial.hear(errata());
  trial.hear(classic_slips());
  if (!trial.explains_nearly_all()) trial.hear(pairs_of_errata());
  return trial.verdict();
}

}  // namespace groundtruth::diagnosis
