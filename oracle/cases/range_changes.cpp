#include <groundtruth/cases/range_changes.hpp>

#include <cmath>

#include <groundtruth/cases/vector_arithmetic.hpp>

namespace groundtruth::cases {

// With new ends at parameters a and a + w, the parameter mu of the new segment is (lambda - a) / w.
EntryAsk with_range_moved(const EntryAsk& ask, Random& random) {
  const double first = random.dyadic(-2, 2, 1);
  const double width = std::ldexp(1.0, static_cast<int>(random.between(-2, 2)));
  EntryAsk result;
  result.from = between(ask.from, ask.to, first);
  result.to = between(ask.from, ask.to, first + width);
  result.lambda_first = (ask.lambda_first - first) / width;
  result.lambda_last = (ask.lambda_last - first) / width;
  for (const Vector& end : {result.from, result.to}) {
    for (const double coordinate : end) {
      if (!std::isfinite(coordinate)) return ask;
    }
  }
  const bool is_range = std::isfinite(result.lambda_first) && std::isfinite(result.lambda_last) &&
                        result.lambda_first <= result.lambda_last;
  return is_range ? result : ask;
}

}  // namespace groundtruth::cases
