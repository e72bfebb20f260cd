#include <algorithm>

#include <groundtruth/definition/first_member.hpp>
#include <groundtruth/definition/running_membership.hpp>

namespace groundtruth::definition {
namespace {

struct Crossing {
  Leaf leaf = 0;
  Moment moment;
  bool enters = false;
};

int compare(const Moment& a, const Moment& b) {
  return (a.numerator * b.denominator - b.numerator * a.denominator).sign();
}

bool later(const Crossing& a, const Crossing& b) { return compare(a.moment, b.moment) > 0; }

Point end_point(const Triple<Whole>& numerators, const Segment& segment) {
  return {numerators, segment.weight};
}

// Where a leaf's truth changes on the segment; Delta is affine there.
std::vector<Crossing> crossings(const Expression& expression, const Segment& segment, const Heights& first,
                                const Sides& first_sides) {
  const Heights last = heights(expression, end_point(segment.last, segment));
  const Sides last_sides = sides(expression, last);
  std::vector<Crossing> result;
  for (Leaf leaf = 0; leaf < first.size(); ++leaf) {
    if (holds(first_sides[leaf], Reading::closed) == holds(last_sides[leaf], Reading::closed)) continue;
    const bool enters = first_sides[leaf] > 0;
    const Whole run = enters ? first[leaf] - last[leaf] : last[leaf] - first[leaf];
    result.push_back({leaf, {enters ? first[leaf] : -first[leaf], run.plain()}, enters});
  }
  return result;
}

}  // namespace

Segment segment_between(const Triple<Real>& first, const Triple<Real>& last) {
  CommonWeight ends = over_common_weight(first, last);
  return {std::move(ends.first), std::move(ends.second), std::move(ends.weight)};
}

Point point_at(const Segment& segment, const Moment& moment) {
  const Triple<Whole> run = segment.last - segment.first;
  return {moment.denominator * segment.first + moment.numerator * run, segment.weight * moment.denominator};
}

std::optional<Moment> first_member(const Expression& expression, const Segment& segment) {
  const Heights first = heights(expression, end_point(segment.first, segment));
  const Sides first_sides = sides(expression, first);
  RunningMembership solid(expression, first_sides);
  if (solid.is_member()) return Moment{};

  std::vector<Crossing> ahead = crossings(expression, segment, first, first_sides);
  std::make_heap(ahead.begin(), ahead.end(), later);
  while (!ahead.empty()) {
    const Moment now = ahead.front().moment;
    std::vector<Leaf> left_behind;
    // Half-spaces are closed: at its crossing a leaf holds, whether the segment enters or leaves it.
    while (!ahead.empty() && compare(ahead.front().moment, now) == 0) {
      const Crossing& crossing = ahead.front();
      if (crossing.enters) solid.enter(crossing.leaf);
      if (!crossing.enters) left_behind.push_back(crossing.leaf);
      std::pop_heap(ahead.begin(), ahead.end(), later);
      ahead.pop_back();
    }
    if (solid.is_member()) return now;
    for (const Leaf leaf : left_behind) solid.leave(leaf);
  }
  return std::nullopt;
}

}  // namespace groundtruth::definition
