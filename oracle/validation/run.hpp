#pragma once
// Puts streams of cases to an implementation and judges what it answers.

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <groundtruth/validation/finding.hpp>
#include <groundtruth/validation/stream.hpp>

namespace groundtruth::validation {

// Which kinds of ask are judged; cases of others are skipped.
using Kinds = std::array<bool, number_of_kinds>;

struct RunPlan {
  judge::Tolerance tolerance;
  Kinds kinds{true, true, true};
  unsigned jobs = 1;
  std::optional<std::chrono::milliseconds> time;  // no batch begins later
  // The run ends when so many asks have hung, as each costs the whole patience.
  std::uint64_t most_hung = 5;
};

// A case and what came of it, mostly one that was not accepted.
struct Failure {
  std::size_t stream = 0;
  cases::Case asked;
  Finding finding;
};

// `enough_failed`: all was asked of the streams that had not failed enough.
enum class Ending { all_asked, enough_failed, out_of_time, interrupted, too_many_hung };

struct Result {
  Tally tally;
  std::vector<Failure> failures;  // by stream, then by their number in it
  std::vector<Failure> accepted;  // a hundred or so of each kind that did not fail
  Ending ending = Ending::all_asked;
  double seconds = 0;
};

// The streams, from 0; null: there are no more.
using StreamAt = std::function<std::unique_ptr<Stream>(std::size_t)>;
using MakeSubject = std::function<std::unique_ptr<implementations::Subject>()>;

struct Watch {
  // Told of each failure as it is found, never from two threads at once.
  std::function<void(const Failure&)> failed = [](const Failure&) {};
  // Told how many were judged.
  std::function<void(std::uint64_t)> judged = [](std::uint64_t) {};
  // Set from outside: to end with what was found so far.
  const std::atomic<bool>* interrupted = nullptr;
};

// Each of `jobs` threads makes a subject of its own and takes a stream at a time, so that, of an
// implementation that answers the same the same, the failures do not depend on `jobs`.
Result run(const RunPlan& plan, const StreamAt& stream_at, const MakeSubject& make_subject,
           const Watch& watch);

}  // namespace groundtruth::validation
