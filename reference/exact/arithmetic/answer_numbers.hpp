#pragma once
// The doubles of an answer, rounded from exact numbers. Private to this folder.

#include <optional>
#include <string>
#include <vector>

#include <groundtruth/exact/arithmetic/root_sum.hpp>
#include <groundtruth/exact/finding.hpp>

namespace groundtruth::exact {

class AnswerNumbers {
 public:
  explicit AnswerNumbers(Digits digits) : digits_(digits) {}

  // Rounded to nearest; encloses each component as "QUANTITY[i]" if digits were asked for.
  Vector round(const std::string& quantity, const std::array<RootSum, 3>& vector);

  // Why there is no answer: a quantity that leaves the range of doubles. The first one, if any.
  const std::optional<Refusal>& refusal() const { return refusal_; }
  Evidence evidence() && { return {"", {}, std::move(enclosures_)}; }

 private:
  Digits digits_;
  std::optional<Refusal> refusal_;
  std::vector<Enclosure> enclosures_;
};

}  // namespace groundtruth::exact
