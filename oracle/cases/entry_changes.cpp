#include <groundtruth/cases/ask_changes.hpp>

#include <algorithm>
#include <utility>

#include <groundtruth/cases/range_changes.hpp>
#include <groundtruth/cases/vector_arithmetic.hpp>

#include "number_changes.hpp"

namespace groundtruth::cases {
namespace {

bool is_finite(const Vector& value) {
  return std::isfinite(value[0]) && std::isfinite(value[1]) && std::isfinite(value[2]);
}

EntryAsk finite_or(const EntryAsk& changed, const EntryAsk& otherwise) {
  const bool is_well_formed = is_finite(changed.from) && is_finite(changed.to) &&
                              std::isfinite(changed.lambda_first) && std::isfinite(changed.lambda_last) &&
                              changed.lambda_first <= changed.lambda_last;
  return is_well_formed ? changed : otherwise;
}

// An end or the range's start or end goes to the entry point, or one ulp beside it.
EntryAsk with_end_at(EntryAsk ask, double lambda, Random& random) {
  const double near = random.one_in(2) ? lambda : one_ulp_off(lambda, random);
  switch (random.below(4)) {
    case 0:
      ask.from = between(ask.from, ask.to, near);
      return ask;
    case 1:
      ask.to = between(ask.from, ask.to, near);
      return ask;
    case 2:
      ask.lambda_first = std::min(near, ask.lambda_last);
      return ask;
    default:
      ask.lambda_last = std::max(near, ask.lambda_first);
      return ask;
  }
}

EntryAsk with_other_range(EntryAsk ask, Random& random) {
  switch (random.below(5)) {
    case 0:
      return with_range_moved(ask, random);
    case 1:
      ask.lambda_first = 0;
      ask.lambda_last = 1;
      return ask;
    case 2:
      ask.lambda_first = ask.lambda_last;
      return ask;
    case 3:
      ask.lambda_first = changed_number(ask.lambda_first, random);
      break;
    default:
      ask.lambda_last = changed_number(ask.lambda_last, random);
  }
  if (ask.lambda_first > ask.lambda_last) std::swap(ask.lambda_first, ask.lambda_last);
  return ask;
}

EntryAsk changed_once(EntryAsk ask, std::optional<double> entered_at, Random& random) {
  const std::uint64_t kind = random.below(10);
  if (kind < 3 && entered_at) return with_end_at(ask, *entered_at, random);
  if (kind < 4) return with_other_range(ask, random);
  if (kind == 4) {
    std::swap(ask.from, ask.to);
    return ask;
  }
  if (kind == 5) {  // the same line, further
    ask.to = between(ask.from, ask.to, random.dyadic(-2, 4, 2));
    return ask;
  }
  Vector& end = random.one_in(2) ? ask.from : ask.to;
  end = changed_vector(end, random);
  return ask;
}

}  // namespace

EntryAsk changed(const EntryAsk& ask, std::optional<double> entered_at, Random& random) {
  EntryAsk result = finite_or(changed_once(ask, entered_at, random), ask);
  if (random.one_in(3)) result = finite_or(changed_once(result, entered_at, random), result);
  return result;
}

}  // namespace groundtruth::cases
