#include <groundtruth/diagnosis/diagnose.hpp>

#include <algorithm>

#include <groundtruth/diagnosis/resemblance.hpp>
#include <groundtruth/diagnosis/suspects.hpp>
#include <groundtruth/diagnosis/witnesses.hpp>

namespace groundtruth::diagnosis {
namespace {

constexpr std::size_t most_failures = 150;
constexpr std::size_t most_accepted = 100;

double share(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

double weight(const Diagnosis& diagnosis) {
  return share(diagnosis.explained, diagnosis.failures) - share(diagnosis.contradicted, diagnosis.accepted);
}

class Trial {
 public:
  Trial(std::span<const Witness> failures, std::span<const Witness> accepted)
      : failures_(in_turns(failures, most_failures)), accepted_(in_turns(accepted, most_accepted)) {}

  // The heaviest of these suspects so far, an earlier one where several weigh alike.
  void hear(const std::vector<Suspect>& suspects, std::size_t errors) {
    for (const Suspect& suspect : suspects) {
      const Diagnosis diagnosis = weigh(suspect);
      if (!best_ || weight(diagnosis) > weight(*best_)) {
        best_ = diagnosis;
        errors_of_best_ = errors;
      } else if (weight(diagnosis) == weight(*best_) && errors == errors_of_best_) {
        best_->equals.push_back(diagnosis.name);
      }
    }
  }

  bool explains_all() const { return best_ && weight(*best_) == 1; }

  std::optional<Diagnosis> verdict() const {
    const bool is_convicted = best_ && share(best_->explained, best_->failures) >= 0.9 &&
                              share(best_->contradicted, best_->accepted) <= 0.02;
    return is_convicted ? best_ : std::nullopt;
  }

 private:
  Diagnosis weigh(const Suspect& suspect) const {
    Diagnosis diagnosis{suspect.name, suspect.explanation, 0, failures_.size(), 0, accepted_.size(), {}};
    const std::size_t most_unexplained = failures_.size() / 10;
    std::size_t unexplained = 0;
    for (const Witness* witness : failures_) {
      const bool is_explained = explains(suspect, *witness);
      diagnosis.explained += is_explained ? 1 : 0;
      unexplained += is_explained ? 0 : 1;
      if (unexplained > most_unexplained) return diagnosis;  // acquitted: the rest would not matter
    }
    for (const Witness* witness : accepted_)
      diagnosis.contradicted += resembles(answer_of(suspect, *witness), witness->got) ? 0 : 1;
    return diagnosis;
  }

  static Answer answer_of(const Suspect& suspect, const Witness& witness) {
    return suspect.answer(witness.asked.scene, witness.asked.ask);
  }

  static bool explains(const Suspect& suspect, const Witness& witness) {
    const Answer suspected = answer_of(suspect, witness);
    return suspect.trace == Trace::rounding ? resembles(suspected, witness.got)
                                            : shares_error(suspected, witness.got, witness.exact);
  }

  const std::vector<const Witness*> failures_, accepted_;
  std::optional<Diagnosis> best_;
  std::size_t errors_of_best_ = 0;
};

}  // namespace

std::optional<Diagnosis> diagnose(std::span<const Witness> failures, std::span<const Witness> accepted) {
  if (failures.empty()) return std::nullopt;
  Trial trial(failures, accepted);
  trial.hear(errata(), 1);
  trial.hear(classic_slips(), 1);
  if (!trial.explains_all()) trial.hear(pairs_of_errata(), 2);
  return trial.verdict();
}

}  // namespace groundtruth::diagnosis
