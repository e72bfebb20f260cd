#include <groundtruth/precision/measurement.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

#include <groundtruth/judge/difference.hpp>
#include <groundtruth/precision/clock.hpp>
#include <groundtruth/precision/ulps.hpp>
#include <groundtruth/text/ask_text.hpp>

namespace groundtruth::precision {
namespace {

constexpr std::size_t fewest_asks = 5;

double median_of(std::vector<double> numbers) {
  if (numbers.empty()) return 0;
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

bool is_refusal(const Answer& answer) {
  const auto* clip = std::get_if<ClipAnswer>(&answer);
  const auto* step = std::get_if<StepAnswer>(&answer);
  return (clip && std::holds_alternative<Refusal>(*clip)) || (step && std::holds_alternative<Refusal>(*step));
}

bool has_number(const Answer& answer) {
  if (const auto* entry = std::get_if<EntryAnswer>(&answer)) return !std::holds_alternative<Miss>(*entry);
  if (const auto* clip = std::get_if<ClipAnswer>(&answer)) return std::holds_alternative<Clipped>(*clip);
  return std::holds_alternative<Stepped>(std::get<StepAnswer>(answer));
}

bool is_wrong(const Answer& got, const Answer& exact) {
  if (is_refusal(got) && is_refusal(exact)) return false;  // whatever their words
  const auto difference = judge::compare({got, {}}, {exact, {}}).difference;
  return difference != judge::Difference::none && difference != judge::Difference::lambda &&
         difference != judge::Difference::numbers;
}

Witness witness_of(const Case& one) {
  return {one.part, one.index, write_ask("\"" + std::to_string(one.index) + "\"", one.ask)};
}

// A tier on all scenes of a pack.
class Prepared {
 public:
  Prepared(const tiers::Tier& tier, const Sample& sample) : sample_(sample) {
    for (const Scene& scene : sample.pack) on_scenes_.push_back(tier.on(scene));
  }

  tiers::TierAnswer answer(const Case& one) const { return on_scenes_[one.part]->answer(one.ask); }

  // Seconds that this many asks take.
  double time(std::size_t asks) const {
    const double start = thread_seconds();
    for (std::size_t i = 0; i < asks; ++i) keep(answer(sample_.cases[i]));
    return thread_seconds() - start;
  }

 private:
  // Whatever is computed must not be left out.
  static void keep(const tiers::TierAnswer& answer) {
    static volatile std::size_t sink;
    sink = sink + answer.index();
  }

  const Sample& sample_;
  std::vector<std::unique_ptr<const tiers::TierOnScene>> on_scenes_;
};

class ErrorsOfTier {
 public:
  explicit ErrorsOfTier(TierResult& result) : result_(result) {}

  void add(const Case& one, const tiers::TierAnswer& said) {
    ++result_.asks;
    const auto* got = std::get_if<Answer>(&said);
    if (got == nullptr) {
      ++result_.undecided;
      return;
    }
    if (is_wrong(*got, one.truth.answer)) {
      if (result_.wrong++ == 0) result_.first_wrong = witness_of(one);
      return;
    }
    if (!has_number(one.truth.answer)) return;
    ulps_.push_back(error_in_ulps(*got, one.truth.answer, one.truth.evidence));
    if (result_.worst && !(ulps_.back() > result_.worst_ulps)) return;
    result_.worst_ulps = ulps_.back();
    result_.worst = witness_of(one);
  }

  void finish() {
    result_.with_number = ulps_.size();
    result_.median_ulps = median_of(ulps_);
  }

 private:
  TierResult& result_;
  std::vector<double> ulps_;
};

// Returns the seconds that an ask takes, roughly.
double find_errors(const Prepared& tier, const Sample& sample, const Effort& effort, TierResult& result) {
  ErrorsOfTier errors(result);
  double seconds = 0;
  for (const Case& one : sample.cases) {
    const double start = thread_seconds();
    const tiers::TierAnswer said = tier.answer(one);
    seconds += thread_seconds() - start;
    errors.add(one, said);
    if (seconds > effort.seconds_of_errors && result.asks >= fewest_asks) break;
  }
  errors.finish();
  return seconds / static_cast<double>(std::max<std::size_t>(result.asks, 1));
}

struct Timed {
  Prepared tier;
  std::size_t place = 0;  // in the results
  std::size_t repetitions = 1;
  std::vector<double> nanoseconds;
};

Spread spread_of(const std::vector<double>& values) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return {median_of(values), *least, *most};
}

void take_times(std::vector<Timed>& timed, const Effort& effort, std::vector<TierResult>& results) {
  for (int round = 0; round < effort.rounds; ++round)
    for (Timed& one : timed) {
      const std::size_t asks = results[one.place].timed_asks;
      one.tier.time(asks);  // fills the caches
      double seconds = 0;
      for (std::size_t i = 0; i < one.repetitions; ++i) seconds += one.tier.time(asks);
      one.nanoseconds.push_back(1e9 * seconds / static_cast<double>(asks * one.repetitions));
    }
  for (const Timed& one : timed) results[one.place].nanoseconds = spread_of(one.nanoseconds);
}

double badness(const TierResult& result) { return std::max(result.worst_ulps, 0.5); }

bool is_as_good(const TierResult& a, const TierResult& b) {
  if (a.share_unanswered() != b.share_unanswered()) return a.share_unanswered() < b.share_unanswered();
  return badness(a) <= badness(b);
}

}  // namespace

std::vector<TierResult> measure(const Sample& sample, const Effort& effort) {
  std::vector<TierResult> results;
  std::vector<Timed> timed;
  for (const auto& tier : tiers::tiers()) {
    TierResult& result = results.emplace_back();
    result.tier = tier->name();
    result.description = tier->description();
    if (const auto omission = tier->omission(sample.kind)) {
      result.omitted = omission->reason;
      continue;
    }
    if (sample.cases.empty()) {
      result.omitted = "no such ask was found";
      continue;
    }
    Timed one{Prepared(*tier, sample), results.size() - 1, 1, {}};
    const double seconds = find_errors(one.tier, sample, effort, result);
    const double affordable = effort.seconds_of_a_round / std::max(seconds, 1e-9);
    result.timed_asks = std::min(result.asks, std::max(fewest_asks, static_cast<std::size_t>(affordable)));
    // The first asks of all came to cold caches: whoever is quick is quicker than that.
    const double once =
        affordable > fewest_asks ? one.tier.time(result.timed_asks) : effort.seconds_of_a_round;
    one.repetitions =
        std::max<std::size_t>(1, static_cast<std::size_t>(effort.seconds_of_a_round / 2 / once));
    timed.push_back(std::move(one));
  }
  take_times(timed, effort, results);
  mark_front(results);
  return results;
}

void mark_front(std::vector<TierResult>& results) {
  for (TierResult& result : results) {
    result.is_on_front = result.omitted.empty();
    for (const TierResult& other : results) {
      if (!other.omitted.empty() || &other == &result || !is_as_good(other, result)) continue;
      const bool is_better = !is_as_good(result, other);
      const double theirs = other.nanoseconds.median, ours = result.nanoseconds.median;
      if (theirs < ours || (theirs == ours && is_better)) result.is_on_front = false;
    }
  }
}

}  // namespace groundtruth::precision
