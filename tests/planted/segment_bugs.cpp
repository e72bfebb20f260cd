// Mistakes about the segment and its range.

#include <algorithm>
#include <cmath>

#include "ways.hpp"

namespace groundtruth::planted {
namespace {

EntryAsk from_zero(EntryAsk ask) {
  ask.lambda_first = 0;
  ask.lambda_last = std::max(ask.lambda_last, 0.0);
  return ask;
}

EntryAsk up_to_one(EntryAsk ask) {
  ask.lambda_last = std::max(ask.lambda_first, 1.0);
  return ask;
}

EntryAsk between_zero_and_one(EntryAsk ask) {
  ask.lambda_first = std::clamp(ask.lambda_first, 0.0, 1.0);
  ask.lambda_last = std::clamp(ask.lambda_last, 0.0, 1.0);
  return ask;
}

double relative_to_range(double lambda, const EntryAsk& ask) {
  const double length = ask.lambda_last - ask.lambda_first;
  return length > 0 ? (lambda - ask.lambda_first) / length : lambda;
}

double not_below_zero(double lambda, const EntryAsk&) { return std::max(lambda, 0.0); }

double zero_where_it_starts(double lambda, const EntryAsk& ask) {
  return lambda == ask.lambda_first ? 0 : lambda;
}

EntryAnswer point_misses(const EntryAsk& ask, const Right& right) {
  return ask.from == ask.to ? Miss{} : right.entry(ask);
}

EntryAnswer instant_misses(const EntryAsk& ask, const Right& right) {
  return ask.lambda_first == ask.lambda_last ? Miss{} : right.entry(ask);
}

EntryAnswer short_range_misses(const EntryAsk& ask, const Right& right) {
  const double length = ask.lambda_last - ask.lambda_first;
  return length > 0 && length < 1e-9 ? Miss{} : right.entry(ask);
}

EntryAnswer short_segment_misses(const EntryAsk& ask, const Right& right) {
  const double x = ask.to[0] - ask.from[0], y = ask.to[1] - ask.from[1], z = ask.to[2] - ask.from[2];
  const double squared = x * x + y * y + z * z;
  return squared > 0 && squared < 1e-6 ? Miss{} : right.entry(ask);
}

EntryAnswer overlong_segment_misses(const EntryAsk& ask, const Right& right) {
  double squared = 0;
  for (std::size_t i = 0; i < 3; ++i) squared += std::pow(ask.to[i] - ask.from[i], 2);
  return std::isinf(squared) ? Miss{} : right.entry(ask);
}

EntryAnswer end_misses(const Meeting& meeting) {
  const bool ends_there = !meeting.at_start && meeting.border.lambda == meeting.ask.lambda_last;
  return ends_there ? EntryAnswer{Miss{}} : meeting.border;
}

EntryAnswer heading_in_is_inside(const Meeting& meeting) {
  const bool heads_in = meeting.at_start && meeting.advance(meeting.border.leaf) < 0;
  return heads_in ? EntryAnswer{Inside{meeting.border.lambda}} : meeting.border;
}

EntryAnswer heading_out_misses(const Meeting& meeting) {
  const bool heads_out = meeting.at_start && meeting.advance(meeting.border.leaf) > 0;
  return heads_out ? EntryAnswer{Miss{}} : meeting.border;
}

EntryAnswer sliding_misses(const Meeting& meeting) {
  for (const Leaf leaf : meeting.tied()) {
    if (meeting.advance(leaf) == 0) return Miss{};
  }
  return meeting.border;
}

// Goes on behind a touch of one point.
EntryAnswer touch_misses(const Meeting& meeting) {
  if (meeting.at_start || meeting.border.lambda >= meeting.ask.lambda_last) return meeting.border;
  EntryAsk behind = meeting.ask;
  behind.lambda_first = meeting.border.lambda;
  for (int ulps = 0; ulps < 2; ++ulps) behind.lambda_first = std::nextafter(behind.lambda_first, HUGE_VAL);
  if (behind.lambda_first > behind.lambda_last) return meeting.border;
  const EntryAnswer next = meeting.right.entry(behind);
  const auto* border = std::get_if<Border>(&next);
  const bool has_left =
      std::holds_alternative<Miss>(next) || (border && border->lambda > behind.lambda_first);
  return has_left ? next : meeting.border;
}

}  // namespace

std::vector<Bug> segment_bugs() {
  using enum Reach;
  constexpr Kind entry = Kind::entry;
  return {
      {"range-from-zero", entry, special, "the range starts at 0 whatever was asked", understands(from_zero)},
      {"range-up-to-one", entry, special, "the range ends at 1 whatever was asked", understands(up_to_one)},
      {"range-clamped", entry, special, "the range is cut to [0, 1]", understands(between_zero_and_one)},
      {"lambda-of-range", entry, special, "lambda counts from the range's ends",
       on_lambdas(relative_to_range)},
      {"lambda-not-negative", entry, special, "a lambda below 0 is answered as 0",
       on_lambdas(not_below_zero)},
      {"start-is-lambda-zero", entry, special, "a start in the solid is answered with lambda 0",
       on_lambdas(zero_where_it_starts)},
      {"point-misses", entry, tied, "from = to is always a miss", answers(point_misses)},
      {"instant-misses", entry, tied, "a range of one value is always a miss", answers(instant_misses)},
      {"short-range-misses", entry, extreme, "a range shorter than 1e-9 is a miss",
       answers(short_range_misses)},
      {"short-segment-misses", entry, extreme, "a segment shorter than 1 mm is a miss",
       answers(short_segment_misses)},
      {"overlong-segment-misses", entry, extreme, "the square of the length overflows: a miss",
       answers(overlong_segment_misses)},
      {"end-misses", entry, tied, "a touch at the range's end is a miss", on_borders(end_misses)},
      {"heading-in-is-inside", entry, tied, "a start on a face, heading in, is inside",
       on_borders(heading_in_is_inside)},
      {"heading-out-misses", entry, tied, "a start on a face, heading out, is a miss",
       on_borders(heading_out_misses)},
      {"sliding-misses", entry, tied, "a segment in the plane of a face misses it",
       on_borders(sliding_misses)},
      {"touch-misses", entry, tied, "a touch of a single point, an edge or a corner, is a miss",
       on_borders(touch_misses)},
  };
}

}  // namespace groundtruth::planted
