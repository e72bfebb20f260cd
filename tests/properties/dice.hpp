#pragma once
// Random choices for generators that shrink by value: quick, and the same for the same seed.

#include <cstdint>
#include <utility>
#include <vector>

#include <rapidcheck.h>

namespace groundtruth::properties {

class Dice {
 public:
  explicit Dice(const rc::Random& random) : random_(random) {}
  explicit Dice(std::uint64_t seed) : random_(seed) {}

  std::uint64_t bits() { return random_.next(); }
  // Each of low, ..., high is as likely.
  int whole(int low, int high) {
    return low + static_cast<int>(bits() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool one_in(int n) { return whole(1, n) == 1; }

  template <typename Value>
  const Value& pick(const std::vector<Value>& values) {
    return values[static_cast<std::size_t>(whole(0, static_cast<int>(values.size()) - 1))];
  }
  template <typename Value>
  Value pick(std::initializer_list<Value> values) {
    return pick(std::vector<Value>(values));
  }
  template <typename Value>
  void shuffle(std::vector<Value>& values) {
    for (std::size_t i = values.size(); i > 1; --i)
      std::swap(values[i - 1], values[static_cast<std::size_t>(whole(0, static_cast<int>(i) - 1))]);
  }

 private:
  rc::Random random_;
};

}  // namespace groundtruth::properties
