#include <groundtruth/diagnosis/shrink.hpp>

#include <algorithm>

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
      for (const auto moves : {with_simpler_shape, with_ordinary_ask, with_simpler_numbers})
        while (!is_spent() && move_on(moves(result_.smallest))) moved = true;
    }
    result_.is_minimum = !moved;
    return result_;
  }

 private:
  static constexpr std::size_t most_together = 32;

  bool is_spent() const {
    return result_.asks >= budget_.most_asks || std::chrono::steady_clock::now() >= end_;
  }

  // To the first of the candidates that is smaller and still fails.
  bool move_on(Cases candidates) {
    std::erase_if(candidates, [&](const cases::Case& candidate) {
      return !(size_of(candidate) < result_.after) || !is_well_formed(candidate);
    });
    for (std::size_t first = 0; first < candidates.size() && !is_spent(); first += most_together) {
      const std::size_t count = std::min(most_together, candidates.size() - first);
      const std::vector<bool> fails = still_fail_(std::span(candidates).subspan(first, count));
      result_.asks += count;
      const auto found = std::find(fails.begin(), fails.end(), true);
      if (found == fails.end()) continue;
      result_.smallest = candidates[first + static_cast<std::size_t>(found - fails.begin())];
      result_.after = size_of(result_.smallest);
      return true;
    }
    return false;
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
