#include <groundtruth/diagnosis/shrink.hpp>

#include <algorithm>
#include <optional>
#include <vector>

#include <groundtruth/diagnosis/inputs.hpp>
#include <groundtruth/diagnosis/moves.hpp>

namespace groundtruth::diagnosis {
namespace {

class Shrinker {
 public:
  Shrinker(const cases::Case& failing, const StillFail& still_fail, const Budget& budget)
      : still_fail_(still_fail),
        budget_(budget),
        end_(std::chrono::steady_clock::now() + budget.most_time),
        result_{failing, size_of(failing), size_of(failing), 0, false} {}

  Shrunk run() {
    bool moved = true;
    while (moved && !is_spent()) {
      moved = false;
      for (const Moves moves : {with_simpler_shape, with_ordinary_ask, with_simpler_numbers})
        while (!is_spent() && move_on(moves)) moved = true;
    }
    result_.is_minimum = !moved && !is_spent();
    return result_;
  }

 private:
  // Asked together, as a journey through a pipe takes its time; but not many large scenes, as the first that
  // fails makes the others idle.
  static constexpr std::size_t most_together = 32;
  static constexpr std::size_t most_leaves_together = 2000;

  bool is_spent() const {
    return result_.asks >= budget_.most_asks || std::chrono::steady_clock::now() >= end_;
  }

  // To the first of the candidates that is smaller and still fails.
  bool move_on(Moves moves) {
    std::vector<cases::Case> together;
    std::size_t leaves = 0;
    std::optional<cases::Case> next;
    const auto ask = [&] {
      next = first_that_fails(together);
      together.clear();
      leaves = 0;
      return !next && !is_spent();
    };
    const bool is_out = moves(result_.smallest, [&](cases::Case&& candidate) {
      const Size size = size_of(candidate);
      if (!(size < result_.after) || !is_well_formed(candidate)) return !is_spent();
      leaves += size.leaves;
      together.push_back(std::move(candidate));
      const bool is_full = together.size() == most_together || leaves >= most_leaves_together ||
                           result_.asks + together.size() >= budget_.most_asks;
      return !is_full || ask();
    });
    if (is_out && !together.empty() && !is_spent()) ask();
    if (!next) return false;
    result_.smallest = std::move(*next);
    result_.after = size_of(result_.smallest);
    return true;
  }

  std::optional<cases::Case> first_that_fails(std::vector<cases::Case>& candidates) {
    const std::vector<bool> fails = still_fail_(candidates);
    result_.asks += candidates.size();
    const auto found = std::find(fails.begin(), fails.end(), true);
    if (found == fails.end()) return std::nullopt;
    return std::move(candidates[static_cast<std::size_t>(found - fails.begin())]);
  }

  const StillFail& still_fail_;
  const Budget budget_;
  const std::chrono::steady_clock::time_point end_;
  Shrunk result_;
};

}  // namespace

Shrunk shrink(const cases::Case& failing, const StillFail& still_fail, const Budget& budget) {
  return Shrinker(failing, still_fail, budget).run();
}

}  // namespace groundtruth::diagnosis
