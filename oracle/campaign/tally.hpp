#pragma once
// What one engine did on one scene's asks, counted against the exact answers.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <groundtruth/judge/difference.hpp>

namespace groundtruth::campaign {

// Which ask: number `index` of the source on scene `part` of a pack.
struct Place {
  std::size_t part = 0;
  std::uint64_t index = 0;
  auto operator<=>(const Place&) const = default;
};

// The largest error seen and, among equals, the first ask that gave it.
struct Worst {
  double ulps = 0;
  Place place;
};

struct Disagreement {
  judge::Difference difference = judge::Difference::none;
  Place place;
};

class Tally {
 public:
  // Only this many disagreements are kept as examples: the first ones.
  static constexpr std::size_t most_examples = 5;

  void add(const judge::Comparison& comparison, Place place);
  // Of a kind that the engine answers, but it was not put to it, to save time.
  void leave_out() { ++left_out_; }
  void add_time(double seconds) { seconds_ += seconds; }
  void merge(const Tally& other);

  std::uint64_t asks() const { return asks_; }
  std::uint64_t left_out() const { return left_out_; }
  std::uint64_t count(judge::Difference difference) const {
    return counts_[static_cast<std::size_t>(difference)];
  }
  std::uint64_t disagreements() const { return asks_ - count(judge::Difference::none); }
  const Worst& worst_lambda() const { return worst_lambda_; }
  const Worst& worst_vector() const { return worst_vector_; }
  const std::vector<Disagreement>& examples() const { return examples_; }
  double nanoseconds_per_ask() const { return asks_ == 0 ? 0 : 1e9 * seconds_ / static_cast<double>(asks_); }

 private:
  std::uint64_t asks_ = 0;
  std::uint64_t left_out_ = 0;
  std::array<std::uint64_t, judge::number_of_differences> counts_{};
  Worst worst_lambda_;
  Worst worst_vector_;
  std::vector<Disagreement> examples_;
  double seconds_ = 0;
};

}  // namespace groundtruth::campaign
