#include <groundtruth/exact/arithmetic/answer_numbers.hpp>

#include <cmath>

#include <groundtruth/exact/arithmetic/rounding.hpp>

namespace groundtruth::exact {

Vector AnswerNumbers::round(const std::string& quantity, const std::array<RootSum, 3>& vector) {
  Vector rounded;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string name = quantity + "[" + std::to_string(i) + "]";
    rounded[i] = nearest_double(vector[i]);
    if (!std::isfinite(rounded[i]) && !refusal_) refusal_ = Refusal{name + " leaves the range of doubles"};
    if (digits_ != Digits::none) {
      enclosures_.push_back(decimal_enclosure(name, vector[i], static_cast<unsigned>(digits_)));
    }
  }
  return rounded;
}

}  // namespace groundtruth::exact
