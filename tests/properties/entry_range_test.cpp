// How answers to one segment hang together: other ranges of it, its parts, the way back, single points.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include <groundtruth/tests/properties/generators.hpp>
#include <groundtruth/tests/properties/witnesses.hpp>

namespace groundtruth::properties {
namespace {

EntryAsk in_range(EntryAsk ask, double first, double last) {
  ask.lambda_first = first;
  ask.lambda_last = last;
  return ask;
}

// Places in the range, both ends among them. Exact for lattice cases.
std::vector<double> places(const EntryAsk& ask) {
  std::vector<double> result;
  for (int k = 0; k <= 8; ++k)
    result.push_back(ask.lambda_first + (ask.lambda_last - ask.lambda_first) * (k / 8.0));
  return result;
}

RC_GTEST_PROP(EntryRange, WhatIsCutOffBeforeOrAfterTheEntryPointDoesNotMatter, ()) {
  const EntryCase c = *lattice_entries();
  const Ground ground(c.shape);
  const Entered whole = ground.entry(c.ask);
  for (const double place : places(c.ask)) {
    const Entered begins_here = ground.entry(in_range(c.ask, place, c.ask.lambda_last));
    const Entered ends_here = ground.entry(in_range(c.ask, c.ask.lambda_first, place));
    if (whole.is_miss()) {
      RC_ASSERT(begins_here.is_miss());
      RC_ASSERT(ends_here.is_miss());
      continue;
    }
    if (Rational(place) < *whole.lambda) RC_ASSERT(begins_here == whole);
    if (Rational(place) < *whole.lambda) RC_ASSERT(ends_here.is_miss());
    if (Rational(place) >= *whole.lambda) RC_ASSERT(ends_here == whole);
    if (Rational(place) > *whole.lambda && !begins_here.is_miss())
      RC_ASSERT(*begins_here.lambda >= Rational(place));
  }
}

// All leaves that bound count there, entered or not, so the set may differ from the one found from afar.
// Nothing before it is in the solid, so it is no interior point.
RC_GTEST_PROP(EntryRange, ARangeThatStartsAtTheEntryPointFindsItOnTheBorder, ()) {
  const EntryCase c = *lattice_entries();
  const Ground ground(c.shape);
  const Entered whole = ground.entry(c.ask);
  if (whole.is_miss()) return;
  const auto lambda = static_cast<double>(*whole.lambda);
  if (Rational(lambda) != *whole.lambda) return;
  const Entered begins_there = ground.entry(in_range(c.ask, lambda, c.ask.lambda_last));
  const Entered point = ground.entry(in_range(c.ask, lambda, lambda));
  RC_ASSERT(same_place(begins_there, whole));
  RC_ASSERT(point == begins_there);
  if (*whole.lambda == Rational(c.ask.lambda_first)) RC_ASSERT(begins_there == whole);
}

RC_GTEST_PROP(EntryRange, APartOfTheSegmentWithItsRangeGivesTheSame, ()) {
  const EntryCase c = *lattice_entries();
  const double scale = 4;
  const double start = *rc::gen::inRange(-8, 9) / 4.0;
  // x(start + lambda / scale), which is exact.
  EntryAsk part = c.ask;
  for (std::size_t i = 0; i < 3; ++i) {
    const double run = c.ask.to[i] - c.ask.from[i];
    part.from[i] = c.ask.from[i] + start * run;
    part.to[i] = part.from[i] + run / scale;
  }
  part.lambda_first = (c.ask.lambda_first - start) * scale;
  part.lambda_last = (c.ask.lambda_last - start) * scale;
  const Ground ground(c.shape);
  const Entered whole = ground.entry(c.ask);
  const Entered found = ground.entry(part);
  RC_ASSERT(found.answer.index() == whole.answer.index());
  RC_ASSERT(found.admissible == whole.admissible);
  if (!whole.is_miss()) RC_ASSERT(*whole.lambda == Rational(start) + *found.lambda / Rational(scale));
}

RC_GTEST_PROP(EntryRange, TheWayBackHitsIffTheWayThereDoesAndFindsTheLastPoint, ()) {
  const EntryCase c = *lattice_entries();
  const Ground ground(c.shape);
  const Entered there = ground.entry(c.ask);
  const Entered back = ground.entry({c.ask.to, c.ask.from, 1 - c.ask.lambda_last, 1 - c.ask.lambda_first});
  RC_ASSERT(there.is_miss() == back.is_miss());
  if (there.is_miss()) return;
  const Rational last = 1 - *back.lambda;
  RC_ASSERT(*there.lambda <= last);
  RC_ASSERT(contains(c.shape, point_at(c.ask, last)));
  for (const double place : places(c.ask)) {
    if (Rational(place) > last) RC_ASSERT(ground.entry(in_range(c.ask, place, c.ask.lambda_last)).is_miss());
  }
}

RC_GTEST_PROP(EntryRange, NoMemberComesBeforeTheEntryPointWhichIsOne, ()) {
  const EntryCase c = *lattice_entries();
  const Ground ground(c.shape);
  const Entered whole = ground.entry(c.ask);
  if (!whole.is_miss()) RC_ASSERT(contains(c.shape, point_at(c.ask, *whole.lambda)));
  for (const double place : places(c.ask)) {
    const bool member = contains(c.shape, point_at(c.ask, Rational(place)));
    if (member) RC_ASSERT(!whole.is_miss());
    if (member) RC_ASSERT(*whole.lambda <= Rational(place));
    RC_ASSERT(ground.entry(in_range(c.ask, place, place)).is_miss() == !member);
  }
}

// SPEC section 3: lambda* is the start of the range or where the segment crosses the plane of a leaf.
RC_GTEST_PROP(EntryRange, TheFirstMemberAmongStartAndCrossingsIsTheEntryPoint, ()) {
  const EntryCase c = *wild_entries();
  const Rational first(c.ask.lambda_first), last(c.ask.lambda_last);
  std::vector<Rational> candidates{first};
  for (const HalfSpace& leaf : leaves_of(c.shape)) {
    const Rational at_from = delta(leaf, point(c.ask.from));
    const Rational at_to = delta(leaf, point(c.ask.to));
    if (at_from == at_to) continue;
    const Rational crossing = at_from / (at_from - at_to);
    if (first <= crossing && crossing <= last) candidates.push_back(crossing);
  }
  std::sort(candidates.begin(), candidates.end());
  const auto found = std::find_if(candidates.begin(), candidates.end(), [&](const Rational& lambda) {
    return contains(c.shape, point_at(c.ask, lambda));
  });
  const Entered entered = Ground(c.shape).entry(c.ask);
  RC_ASSERT(entered.is_miss() == (found == candidates.end()));
  if (!entered.is_miss()) RC_ASSERT(*entered.lambda == *found);
}

}  // namespace
}  // namespace groundtruth::properties
