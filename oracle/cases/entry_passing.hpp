#pragma once
// Segments through a given point.

#include <groundtruth/cases/landmarks.hpp>
#include <groundtruth/cases/random.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::cases {

// From the side of `direction` (point + a direction) through the point and on to point - b direction, with
// small integers a > 0 and b >= 0. The range is [0, 1], or now and then another one that is a short dyadic:
// partly or wholly negative, beyond 1, tiny. The line goes through the point exactly if point and direction
// are short.
EntryAsk passing(const Vector& point, const Vector& direction, Random& random);

// The ask whose range starts (or ends) exactly at the point: lambda_first (or lambda_last) is 0 (or 1), or
// now and then another short dyadic.
EntryAsk starting_at(const Vector& point, const Vector& heading, Random& random);
EntryAsk ending_at(const Vector& point, const Vector& heading, Random& random);

// On a face, an edge, a corner or a crossing, at random.
struct Feature {
  Vector point{};
  Vector normal{};  // of a face there, outward
};
Feature any_feature(const Landmarks& landmarks, Random& random);

}  // namespace groundtruth::cases
