#include <groundtruth/validation/run.hpp>

#include <algorithm>
#include <future>
#include <mutex>
#include <tuple>
#include <utility>

#include <groundtruth/validation/examination.hpp>

namespace groundtruth::validation {
namespace {

using Clock = std::chrono::steady_clock;

class Run {
 public:
  Run(const RunPlan& plan, const StreamAt& stream_at, const Watch& watch)
      : plan_(plan), stream_at_(stream_at), watch_(watch), start_(Clock::now()) {}

  void work(implementations::Subject& subject) {
    while (!is_over()) {
      const std::size_t number = next_stream_++;
      const std::unique_ptr<Stream> stream = stream_at_(number);
      if (stream == nullptr) return;
      follow(number, *stream, subject);
    }
  }

  Result take_result() {
    std::sort(result_.failures.begin(), result_.failures.end(),
              [](const Failure& left, const Failure& right) {
                return std::tie(left.stream, left.finding.ask_number) <
                       std::tie(right.stream, right.finding.ask_number);
              });
    if (result_.ending == Ending::all_asked && enough_failed_) result_.ending = Ending::enough_failed;
    result_.seconds = seconds();
    return std::move(result_);
  }

 private:
  void follow(std::size_t number, Stream& stream, implementations::Subject& subject) {
    std::uint64_t asked = 0;
    while (!is_over()) {
      const std::optional<Batch> batch = stream.next();
      if (!batch) {
        enough_failed_ = enough_failed_ || stream.has_failed_enough();
        return;
      }
      std::vector<Finding> findings = examine(*batch, plan_.kinds, plan_.tolerance, subject);
      if (is_interrupted()) return;  // the interrupt may have reached the implementation as well
      for (Finding& finding : findings) finding.ask_number = asked++;
      stream.learn(findings);
      note(number, *batch, findings);
    }
  }

  void note(std::size_t stream, const Batch& batch, const std::vector<Finding>& findings) {
    const std::lock_guard lock(mutex_);
    for (std::size_t i = 0; i < findings.size(); ++i) {
      const Outcome outcome = findings[i].outcome;
      result_.tally.add(kind_of_ask(batch.asks[i]), outcome);
      const bool is_sample = outcome == Outcome::accepted && samples_[batch.asks[i].index()]++ < most_samples;
      if (!is_failure(outcome) && !is_sample) continue;
      std::vector<Failure>& list = is_sample ? result_.accepted : result_.failures;
      list.push_back({stream, {batch.ids[i], *batch.scene, batch.asks[i], {}, {}}, findings[i]});
      if (!is_sample) watch_.failed(list.back());
    }
    watch_.judged(result_.tally.judged());
  }

  bool is_interrupted() const { return watch_.interrupted != nullptr && *watch_.interrupted; }

  bool is_over() {
    const std::lock_guard lock(mutex_);
    Ending& ending = result_.ending;
    if (ending != Ending::all_asked) return true;
    if (is_interrupted()) ending = Ending::interrupted;
    if (plan_.time && Clock::now() - start_ > *plan_.time) ending = Ending::out_of_time;
    if (result_.tally.count(Outcome::hung) >= plan_.most_hung) ending = Ending::too_many_hung;
    return ending != Ending::all_asked;
  }

  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

  const RunPlan& plan_;
  const StreamAt& stream_at_;
  const Watch& watch_;
  Clock::time_point start_;
  std::atomic<std::size_t> next_stream_ = 0;
  std::atomic<bool> enough_failed_ = false;
  std::mutex mutex_;
  static constexpr std::uint64_t most_samples = 100;
  std::array<std::uint64_t, number_of_kinds> samples_{};  // accepted cases of each kind so far
  Result result_;
};

}  // namespace

Result run(const RunPlan& plan, const StreamAt& stream_at, const MakeSubject& make_subject,
           const Watch& watch) {
  Run one(plan, stream_at, watch);
  std::vector<std::unique_ptr<implementations::Subject>> subjects;
  for (unsigned i = 0; i < plan.jobs; ++i) subjects.push_back(make_subject());
  std::vector<std::future<void>> working;
  for (const auto& subject : subjects) {
    working.push_back(std::async(std::launch::async, [&] { one.work(*subject); }));
  }
  for (std::future<void>& finished : working) finished.get();
  return one.take_result();
}

}  // namespace groundtruth::validation
